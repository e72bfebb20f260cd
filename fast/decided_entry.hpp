#pragma once
// An entry answer together with the stages that decided it, for tests and histograms. Not installed.

#include <groundtruth/fast/cell.hpp>
#include <groundtruth/fast/scene.hpp>
#include <groundtruth/fast/search_task.hpp>
#include <groundtruth/fast/stage.hpp>
#include <groundtruth/problem/answer.hpp>
#include <groundtruth/problem/ask.hpp>

namespace groundtruth::fast {

struct EntryStages {
  Stage place = Stage::none;     // hit or miss, and the leaf
  Stage lambda = Stage::none;    // none: it is the range's first, or there is none
  Stage material = Stage::none;  // none: no face is hit
};

struct DecidedEntry : EntryStages {
  EntryAnswer answer;
};

// entry_point() is its answer.
DecidedEntry decide_entry(const Scene& scene, const EntryAsk& ask);
// The answer goes where it is wanted.
EntryStages decide_entry(const Scene& scene, const EntryAsk& ask, EntryAnswer& answer);
// The answer of an ask that hits this face, as a search found.
void answer_with_face(const Scene& scene, const Probe& probe, const EntryAsk& ask, const SearchResult& result,
                      const Face& face, EntryAnswer& answer);

}  // namespace groundtruth::fast
