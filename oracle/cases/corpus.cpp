#include <groundtruth/cases/corpus.hpp>

#include <iterator>

#include "corpus_parts.hpp"

namespace groundtruth::cases {
namespace {

std::vector<Case> all_chapters() {
  std::vector<Case> cases;
  for (const auto chapter : {corpus_of_faces, corpus_of_expressions, corpus_of_paints, corpus_of_ranges,
                             corpus_of_clips, corpus_of_landings, corpus_of_contacts, corpus_of_slipping}) {
    std::vector<Case> more = chapter();
    std::move(more.begin(), more.end(), std::back_inserter(cases));
  }
  return cases;
}

}  // namespace

const std::vector<Case>& corpus() {
  static const std::vector<Case> cases = all_chapters();
  return cases;
}

}  // namespace groundtruth::cases
