#pragma once
// Cases from their names.

#include <memory>

#include <groundtruth/cases/case.hpp>
#include <groundtruth/problem/answer.hpp>
#include <groundtruth/validation/case_name.hpp>

namespace groundtruth::validation {

// The scene that the fresh cases of a batch share.
Scene scene_of_batch(std::uint64_t seed, std::uint64_t strand, std::uint64_t batch);

// Fresh asks about one batch's scene.
class FreshAsks {
 public:
  FreshAsks(const Scene& scene, std::uint64_t seed, std::uint64_t strand, std::uint64_t batch);
  ~FreshAsks();
  Ask ask_at(Kind kind, std::uint64_t number) const;

 private:
  class Sources;
  std::unique_ptr<const Sources> sources_;
};

Scene changed_scene(const Scene& scene, const Change& change);

// `exact` is the exact answer to `ask` about the scene before the change.
Ask changed_ask(const Ask& ask, const Answer& exact, const Change& change);

// Asks the exact engine for what the changes lean on.
cases::Case make_case(const CaseName& name);

}  // namespace groundtruth::validation
