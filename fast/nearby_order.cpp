#include <groundtruth/fast/nearby_order.hpp>

#include <algorithm>
#include <bit>

namespace groundtruth::fast {

namespace {

// Of less so much stays in the caches that order costs more than it gains.
constexpr std::size_t fewest_nodes = 35000;
constexpr std::size_t fewest_asks = 256;
constexpr unsigned most_bits = 7;

Box box_of(const BoxNode& root) {
  Box box = nowhere;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (const float low : root.low[axis]) box.low[axis] = std::min(box.low[axis], double{low});
    for (const float high : root.high[axis]) box.high[axis] = std::max(box.high[axis], double{high});
  }
  return box;
}

// The bits of a number, each followed by a free one.
std::uint32_t spread(std::uint32_t x) {
  x = (x | x << 4) & 0x0f0f;
  x = (x | x << 2) & 0x3333;
  return (x | x << 1) & 0x5555;
}

}  // namespace

NearbyOrder::NearbyOrder(const Scene& scene) {
  const auto& nodes = scene.parts().hierarchy.nodes;
  is_large_ = nodes.size() >= fewest_nodes;
  if (!is_large_) return;
  const Box box = box_of(nodes.front());
  const auto width = [&](std::size_t axis) { return box.high[axis] - box.low[axis]; };
  const std::size_t thinnest = width(2) <= std::min(width(0), width(1)) ? 2 : width(1) <= width(0) ? 1 : 0;
  axes_[0] = thinnest == 0 ? 1 : 0;
  axes_[1] = thinnest == 2 ? 1 : 2;
  for (int i = 0; i < 2; ++i) {
    low_[i] = box.low[axes_[i]];
    width_[i] = width(axes_[i]);
  }
}

std::span<const std::uint32_t> NearbyOrder::of(std::span<const EntryAsk> asks) {
  if (!is_large_ || asks.size() < fewest_asks) return {};
  choose_squares(asks.size());
  if (follow_each_other(asks)) return {};
  const std::size_t square_count = std::size_t{1} << (2 * bits_);
  ends_.assign(square_count + 1, 0);
  squares_.resize(asks.size());
  for (std::size_t i = 0; i != asks.size(); ++i) {
    squares_[i] = square_of(asks[i]);
    ++ends_[squares_[i] + 1];
  }
  for (std::size_t square = 1; square != square_count; ++square) ends_[square] += ends_[square - 1];
  order_.resize(asks.size());
  for (std::size_t i = 0; i != asks.size(); ++i) order_[ends_[squares_[i]]++] = static_cast<std::uint32_t>(i);
  return order_;
}

// About an ask a square.
void NearbyOrder::choose_squares(std::size_t ask_count) {
  bits_ = std::min(most_bits, static_cast<unsigned>(std::bit_width(ask_count)) / 2);
  for (int i = 0; i < 2; ++i) per_metre_[i] = static_cast<double>(1U << bits_) / width_[i];
}

// Outside, or nowhere at all, is somewhere on the rim: this is about speed alone.
std::uint32_t NearbyOrder::square_of(const EntryAsk& ask) const {
  const double last = (1U << bits_) - 1;
  std::uint32_t place[2];
  for (int i = 0; i < 2; ++i) {
    const double x = (ask.from[axes_[i]] - low_[i]) * per_metre_[i];
    place[i] = x > 0 ? static_cast<std::uint32_t>(x < last ? x : last) : 0;
  }
  return spread(place[0]) | spread(place[1]) << 1;
}

// Most of some asks start in a square where one of the few before them does.
bool NearbyOrder::follow_each_other(std::span<const EntryAsk> asks) const {
  constexpr std::size_t sample = 256, few = 16;
  std::uint32_t last_squares[few];
  std::fill_n(last_squares, few, ~std::uint32_t{0});
  std::size_t followers = 0;
  for (std::size_t i = 0; i != sample; ++i) {
    const std::uint32_t square = square_of(asks[i]);
    followers += std::find(last_squares, last_squares + few, square) != last_squares + few;
    last_squares[i % few] = square;
  }
  return followers > sample / 2;
}

}  // namespace groundtruth::fast
