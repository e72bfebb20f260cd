#pragma once
// Asks in an order in which neighbours in the scene follow each other. Not installed.

#include <cstdint>
#include <span>
#include <vector>

#include <groundtruth/fast/scene.hpp>
#include <groundtruth/problem/ask.hpp>

namespace groundtruth::fast {

// What an ask has brought into the caches, and how its branches went, then serves the next ones.
class NearbyOrder {
 public:
  explicit NearbyOrder(const Scene& scene);

  // The places of the asks, squares along a Z-shaped curve by where the asks start. Empty: as they stand is
  // as good, because the scene is not very large, they are few, or they follow each other anyway. Valid until
  // the next call. Requires fewer than 2^32 asks.
  std::span<const std::uint32_t> of(std::span<const EntryAsk> asks);

 private:
  std::uint32_t square_of(const EntryAsk& ask) const;
  bool follow_each_other(std::span<const EntryAsk> asks) const;
  void choose_squares(std::size_t ask_count);

  bool is_large_;
  std::size_t axes_[2]{};  // the scene's two widest
  double low_[2]{}, width_[2]{};
  unsigned bits_ = 0;  // of a square's place along one axis
  double per_metre_[2]{};
  std::vector<std::uint32_t> squares_, ends_, order_;
};

}  // namespace groundtruth::fast
