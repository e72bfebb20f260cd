#pragma once
// page.css and page.js, packed into the program when it is built. Private to this folder.

namespace groundtruth::page {

extern const char* const style_sheet;
extern const char* const script;

}  // namespace groundtruth::page
