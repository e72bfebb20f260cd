#pragma once
// Explanations as one page of HTML: no network, no other file; all facts can be read without its script.

#include <string>
#include <vector>

#include <groundtruth/explanation/explanation.hpp>

namespace groundtruth::page {

struct Section {
  explanation::Explanation explanation;
  std::string replay_command;
  std::string heading;               // empty: the ask's id
  std::vector<std::string> remarks;  // paragraphs under it
};

// Requires at least one section. Several are gone through one by one: a recorded chain, or groups of
// failures. The state stands in the page's hash: #case=2&stop=3&zoom=1.
std::string html_page(const std::vector<Section>& sections, const std::string& title);

}  // namespace groundtruth::page
