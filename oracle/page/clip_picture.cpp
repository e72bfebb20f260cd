#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "force_pictures.hpp"
#include "markup.hpp"

namespace groundtruth::page {
namespace {

using namespace explanation;

constexpr double size = 460, middle = size / 2;

// In doubles, for the eye only.
struct Forces {
  double radius, brake, corner;  // mu N, B, s
  Dot before, after;
};

Forces forces_in(const ClipFacts& facts) {
  Forces f{};
  f.radius = nearby_root(facts.disc_squared());
  f.brake = nearby(facts.brake);
  f.corner = f.brake < f.radius ? std::sqrt(f.radius * f.radius - f.brake * f.brake) : 0;
  f.before = {facts.x_sign * nearby_root(facts.x_squared), facts.y_sign * nearby_root(facts.y_squared)};
  f.after = f.before;
  const double length = std::hypot(f.before.x, f.before.y);
  switch (facts.which) {
    case ClipCase::band:
      f.after.x = facts.x_sign * f.brake;
      break;
    case ClipCase::corner:
      f.after = {facts.x_sign * f.brake, facts.y_sign * f.corner};
      break;
    case ClipCase::circle:
      f.after = {f.before.x * f.radius / length, f.before.y * f.radius / length};
      break;
    default:
      break;
  }
  return f;
}

class ClipDrawing {
 public:
  explicit ClipDrawing(const ClipFacts& facts)
      : facts_(facts),
        forces_(forces_in(facts)),
        picture_(size, size, "Friction border in surface coordinates",
                 fmt::format(
                     "{}. Force before ({:.4g}, {:.4g}) N, after ({:.4g}, {:.4g}) N; friction disc of radius "
                     "{:.4g} N, brake band of half width {:.4g} N",
                     explanation::name_of(facts.which), forces_.before.x, forces_.before.y, forces_.after.x,
                     forces_.after.y, forces_.radius, forces_.brake)) {
    const double length = std::hypot(forces_.before.x, forces_.before.y);
    double reach = std::max(forces_.radius, std::min(length, 5 * forces_.radius));
    if (reach == 0) reach = length > 0 ? length : 1;
    reach_ = 1.3 * reach;
  }

  std::string draw() {
    regions();
    border();
    forces();
    return picture_.finished();
  }

 private:
  Dot pixel(double x, double y) const {
    const auto capped = [&](double v) { return std::clamp(v / reach_, -1.0, 1.0) * middle; };
    return {middle + capped(x), middle - capped(y)};
  }

  void regions() {
    const double b = forces_.brake, s = forces_.corner, far = 4 * reach_;
    picture_.rectangle({0, 0}, size, size, "case3");
    if (forces_.corner == 0) return;
    for (const int sx : {-1, 1}) {
      picture_.polygon({pixel(sx * b, s), pixel(sx * far, s), pixel(sx * far, -s), pixel(sx * b, -s)},
                       "case1");
      for (const int sy : {-1, 1}) picture_.polygon(wedge(sx, sy), "case2");
    }
    label(b + 0.55 * (reach_ - b), -0.5 * s, "case 1");
    label(b + 0.5 * (reach_ - b), std::min(s + 0.35 * (reach_ - b) * s / (b + 1e-300), 0.5 * (s + reach_)),
          "case 2");
  }

  // Where the band's and the disc's corner is nearest: between the band's edge and the ray through the
  // corner.
  std::vector<Dot> wedge(int sx, int sy) const {
    const double b = forces_.brake, s = forces_.corner;
    const double to_side = b > 0 ? reach_ / b : 1e300, to_top = reach_ / s;
    const double t = std::min(to_side, to_top);
    std::vector<Dot> corners{pixel(sx * b, sy * s), pixel(sx * reach_, sy * s)};
    if (to_top < to_side) corners.push_back(pixel(sx * reach_, sy * reach_));
    corners.push_back(pixel(sx * t * b, sy * t * s));
    return corners;
  }

  void label(double x, double y, const std::string& words) {
    picture_.text(pixel(x, y), "middle", words, "halo");
  }

  void border() {
    const double r = forces_.radius, b = std::min(forces_.brake, r), s = forces_.corner;
    const Dot a = pixel(b, s), d = pixel(b, -s), c = pixel(-b, -s), e = pixel(-b, s);
    const double radius = r / reach_ * middle;
    if (forces_.corner == 0) {
      picture_.circle({middle, middle}, radius, "border");
    } else {
      picture_.path(
          fmt::format("M{:.1f},{:.1f} L{:.1f},{:.1f} A{:.1f},{:.1f} 0 0 1 {:.1f},{:.1f} L{:.1f},{:.1f} "
                      "A{:.1f},{:.1f} 0 0 1 {:.1f},{:.1f} Z",
                      a.x, a.y, d.x, d.y, radius, radius, c.x, c.y, e.x, e.y, radius, radius, a.x, a.y),
          "border");
      picture_.circle({middle, middle}, radius, "disc");
    }
    picture_.line({0, middle}, {size, middle}, "axis");
    picture_.line({middle, 0}, {middle, size}, "axis");
    picture_.text({size - 6, middle - 6}, "end", "F'x: braked", "halo");
    picture_.text({middle + 6, 16}, "start", "F'y: sideways", "halo");
    picture_.text({8, 16}, "start", "case 3", "halo");
    picture_.text({middle - 8, middle + 0.3 * middle}, "end", "stick", "halo");
  }

  void forces() {
    const Dot origin{middle, middle};
    const Dot before = pixel(forces_.before.x, forces_.before.y),
              after = pixel(forces_.after.x, forces_.after.y);
    picture_.arrow(origin, before, "before");
    if (facts_.which != ClipCase::stick) picture_.line(before, after, "projection");
    picture_.arrow(origin, after, "after");
    picture_.circle(before, 4, "before-tip");
    picture_.circle(after, 5, "after-tip");
    const bool right = before.x > middle;
    const std::string words =
        std::hypot(forces_.before.x, forces_.before.y) > reach_ * 1.4 ? "before (far outside)" : "before";
    picture_.text({before.x + (right ? -8 : 8), std::clamp(before.y - 10, 30.0, size - 8)},
                  right ? "end" : "start", facts_.which == ClipCase::stick ? "before = after" : words,
                  "halo");
    if (facts_.which != ClipCase::stick)
      picture_.text({after.x + 8, std::clamp(after.y + 18, 30.0, size - 8)}, "start", "after", "halo");
  }

  const ClipFacts& facts_;
  Forces forces_;
  Picture picture_;
  double reach_ = 1;
};

}  // namespace

std::string clip_picture(const ClipFacts& facts) {
  return facts.which == ClipCase::too_steep ? "" : ClipDrawing(facts).draw();
}

}  // namespace groundtruth::page
