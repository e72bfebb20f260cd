#include <groundtruth/tests/bench/asks.hpp>

#include <cmath>
#include <random>

namespace groundtruth::bench {

namespace {

class Chooser {
 public:
  double between(double low, double high) {
    return low + (high - low) * static_cast<double>(engine_() >> 11) * 0x1p-53;
  }
  Vector point(const Extent& extent) {
    return {between(extent.start, extent.start + extent.width),
            between(extent.start, extent.start + extent.depth), between(extent.low, extent.high)};
  }

 private:
  std::mt19937_64 engine_{1};
};

}  // namespace

std::vector<EntryAsk> struts(const Extent& extent, std::size_t count) {
  Chooser chooser;
  std::vector<EntryAsk> asks(count);
  for (EntryAsk& ask : asks) {
    ask.from = chooser.point(extent);
    const double length = chooser.between(1, 3);
    ask.to = {ask.from[0] + chooser.between(-0.2, 0.2) * length,
              ask.from[1] + chooser.between(-0.2, 0.2) * length, ask.from[2] - length};
  }
  return asks;
}

std::vector<EntryAsk> taxi(const Extent& extent, std::size_t count) {
  constexpr Vector wheels[] = {{0, 0, 0}, {-6.03, 2.51, 0}, {-6.03, -2.51, 0}};
  std::vector<EntryAsk> asks(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double way = 0.0203 * static_cast<double>(i / 3);
    const double x = extent.start + std::fmod(7.1 + way, extent.width);
    const double y = extent.start + std::fmod(3.3 + 0.317 * way, extent.depth);
    const Vector& wheel = wheels[i % 3];
    asks[i].from = {x + wheel[0], y + wheel[1], 1.1 + extent.low};
    asks[i].to = {x + wheel[0] + 0.03, y + wheel[1] + 0.01, -0.7 + extent.low};
  }
  return asks;
}

std::vector<EntryAsk> long_ones(const Extent& extent, std::size_t count) {
  Chooser chooser;
  std::vector<EntryAsk> asks(count);
  for (EntryAsk& ask : asks) {
    ask.from = chooser.point(extent);
    ask.from[2] += 10;
    const double angle = chooser.between(0, 6.28), length = chooser.between(100, 1000);
    ask.to = {ask.from[0] + length * std::cos(angle), ask.from[1] + length * std::sin(angle),
              ask.from[2] - length * chooser.between(0, 0.1)};
  }
  return asks;
}

}  // namespace groundtruth::bench
