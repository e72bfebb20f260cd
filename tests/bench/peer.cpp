#include <groundtruth/tests/bench/peer.hpp>

#include <algorithm>
#include <cmath>

#include <groundtruth/as_written/entry_point.hpp>
#include <groundtruth/exact/entry_point.hpp>
#include <groundtruth/fast/entry_point.hpp>
#include <groundtruth/fast/follower.hpp>
#include <groundtruth/tests/bench/polytope.hpp>

namespace groundtruth::bench {

namespace {

template <class IsHit>
AnswerAll counting(IsHit is_hit) {
  return [=](std::span<const EntryAsk> asks) {
    std::size_t hits = 0;
    for (const EntryAsk& ask : asks) hits += is_hit(ask);
    return hits;
  };
}

bool is_hit(const EntryAnswer& answer) { return !std::holds_alternative<Miss>(answer); }

double delta(const HalfSpace& half_space, const Vector& x) {
  const auto& [n, d] = half_space;
  return n[0] * x[0] + n[1] * x[1] + n[2] * x[2] - d;
}

struct Clip {
  double lambda = 2;
  std::size_t leaf = 0;
};

Clip clip_in_one_pass(const Cell& cell, const EntryAsk& ask) {
  double first = 0, last = 1;
  std::size_t leaf = 0;
  for (std::size_t i = 0; i < cell.size(); ++i) {
    const double a = delta(cell[i], ask.from), b = delta(cell[i], ask.to);
    if (a > 0 && b > 0) return {};
    if (a > 0 && a / (a - b) > first) {
      first = a / (a - b);
      leaf = i;
    } else if (b > 0) {
      last = std::min(last, a / (a - b));
    }
  }
  return first <= last ? Clip{first, leaf} : Clip{};
}

}  // namespace

Peer fast_one_by_one(std::shared_ptr<const fast::Scene> scene) {
  return {"fast", counting([=](const EntryAsk& ask) { return is_hit(fast::entry_point(*scene, ask)); })};
}

Peer fast_warm(std::shared_ptr<const fast::Scene> scene) {
  return {"fast warm", [=](std::span<const EntryAsk> asks) {
            std::vector<fast::Follower> wheels(3, fast::Follower(*scene));
            std::size_t hits = 0;
            for (std::size_t i = 0; i < asks.size(); ++i)
              hits += is_hit(wheels[i % wheels.size()].entry_point(asks[i]));
            return hits;
          }};
}

Peer fast_in_bulk(std::shared_ptr<const fast::Scene> scene) {
  const auto answers = std::make_shared<std::vector<EntryAnswer>>();
  return {"fast bulk", [=](std::span<const EntryAsk> asks) {
            answers->resize(asks.size());
            fast::entry_points(*scene, asks, *answers);
            return static_cast<std::size_t>(std::count_if(answers->begin(), answers->end(), is_hit));
          }};
}

Peer one_pass_clip(const Scene& scene) {
  const std::vector<Cell> cells = cells_of(scene);
  if (cells.size() != 1) return {"one-pass clip", {}};
  return {"one-pass clip", counting([cell = cells.front()](const EntryAsk& ask) {
            const Clip clip = clip_in_one_pass(cell, ask);
            return clip.lambda <= 1 && clip.leaf < cell.size();
          })};
}

Peer naive_doubles(const Scene& scene) {
  const auto plain = std::make_shared<as_written::Scene>(scene);
  return {"naive doubles", counting([=](const EntryAsk& ask) {
            return is_hit(as_written::entry_point(*plain, ask, as_written::Errata{}));
          }),
          Pace::slow};
}

Peer exact_engine(const Scene& scene) {
  const auto prepared = std::make_shared<exact::Scene>(scene);
  return {"exact",
          counting([=](const EntryAsk& ask) { return is_hit(exact::entry_point(*prepared, ask).answer); }),
          Pace::slow};
}

}  // namespace groundtruth::bench
