#include <groundtruth/fast/entry_point.hpp>

#include <groundtruth/fast/cell_kernels.hpp>
#include <groundtruth/fast/decided_entry.hpp>
#include <groundtruth/fast/paint.hpp>
#include <groundtruth/fast/undecided.hpp>

namespace groundtruth::fast {

namespace {

// Answers go where they are wanted, and the rest is returned.
EntryStages decide_exactly(const Scene& scene, const Probe& probe, const EntryAsk& ask, SearchResult& result,
                           EntryAnswer& answer) {
  const double lower = result.lower();
  const auto entry = decide(scene, probe, ask, result);
  if (!entry) {
    answer = Miss{};
    return {Stage::exact, Stage::none, Stage::none};
  }
  const RoundedLambda& lambda = entry->lambda;
  if (entry->leaf == no_leaf) {
    answer = Inside{lambda.value};
    return {Stage::exact, lambda.stage, Stage::none};
  }
  const Face face{entry->leaf, entry->half_space, {}};
  const HalfSpace* const crossed = entry->crossed ? &*entry->crossed : nullptr;
  const FaceMaterial found = material_at(scene, probe, ask, {lower, result.upper, face, crossed});
  answer = Border{lambda.value, face.leaf, face.half_space.normal, found.material};
  return {Stage::exact, lambda.stage, found.stage};
}

[[gnu::always_inline]] inline EntryStages hit(const Scene& scene, const Probe& probe, const EntryAsk& ask,
                                              const SearchResult& result, const Face& face,
                                              EntryAnswer& answer) {
  const RoundedLambda lambda = correctly_rounded_crossing(*scene.parts().kernels, face.half_space, ask);
  // Field by field, for the same reason as HitPlace.
  auto& border = answer.emplace<Border>();
  border.lambda = lambda.value;
  border.leaf = face.leaf;
  border.normal_in_world = face.half_space.normal;
  if (const auto material = sure_material(face)) {
    border.material = *material;
    return {Stage::doubles, lambda.stage, Stage::doubles};
  }
  const FaceMaterial found =
      material_at(scene, probe, ask, {result.lower(), result.upper, face, &face.half_space});
  border.material = found.material;
  return {Stage::doubles, lambda.stage, found.stage};
}

EntryStages decide(const Scene& scene, const EntryAsk& ask, EntryAnswer& answer) {
  const Probe probe(ask);
  SearchResult result;
  search(scene, probe, result);
  if (result.starts_inside) {
    answer = Inside{ask.lambda_first + 0.0};
    return {Stage::doubles, Stage::none, Stage::none};
  }
  if (result.contenders.empty()) {
    answer = Miss{};
    return {Stage::doubles, Stage::none, Stage::none};
  }
  const Face face = sole_face(scene, probe, result);
  if (face.leaf == no_leaf) return decide_exactly(scene, probe, ask, result, answer);
  return hit(scene, probe, ask, result, face, answer);
}

}  // namespace

DecidedEntry decide_entry(const Scene& scene, const EntryAsk& ask) {
  DecidedEntry entry;
  static_cast<EntryStages&>(entry) = decide(scene, ask, entry.answer);
  return entry;
}

EntryStages decide_entry(const Scene& scene, const EntryAsk& ask, EntryAnswer& answer) {
  return decide(scene, ask, answer);
}

void answer_with_face(const Scene& scene, const Probe& probe, const EntryAsk& ask, const SearchResult& result,
                      const Face& face, EntryAnswer& answer) {
  hit(scene, probe, ask, result, face, answer);
}

EntryAnswer entry_point(const Scene& scene, const EntryAsk& ask) {
  EntryAnswer answer;
  decide(scene, ask, answer);
  return answer;
}

}  // namespace groundtruth::fast
