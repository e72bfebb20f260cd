#pragma once
// Text in HTML, SVG and XML.

#include <string>
#include <string_view>

namespace groundtruth::report {

// With entities for &, <, > and ", so that it may stand between tags and in attributes.
std::string escaped(std::string_view text);

}  // namespace groundtruth::report
