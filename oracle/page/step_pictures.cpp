#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "force_pictures.hpp"
#include "markup.hpp"

namespace groundtruth::page {
namespace {

using namespace explanation;

struct Place {
  const char* name;
  double x, y;
};

constexpr std::array places{Place{"free", 90, 130},
                            Place{"stick", 270, 60},
                            Place{"slip", 270, 200},
                            Place{"wheel broken", 470, 40},
                            Place{"surface too steep", 470, 100},
                            Place{"surface gave way", 470, 160},
                            Place{"refused", 470, 220}};

const Place& place_named(const std::string& name) {
  return *std::find_if(places.begin(), places.end() - 1,
                       [&](const Place& place) { return name == place.name; });
}

constexpr double box_width = 130, box_height = 36;

// From box to box, cut off at their edges.
void draw_way(Picture& picture, const Place& from, const Place& to, double shift,
              const std::string& classes) {
  const double length = std::hypot(to.x - from.x, to.y - from.y);
  const double ux = (to.x - from.x) / length, uy = (to.y - from.y) / length;
  const double to_edge = std::min(0.5 * box_width / std::max(std::abs(ux), 1e-9),
                                  0.5 * box_height / std::max(std::abs(uy), 1e-9));
  const double sx = -uy * shift, sy = ux * shift;
  picture.arrow({from.x + ux * to_edge + sx, from.y + uy * to_edge + sy},
                {to.x - ux * to_edge + sx, to.y - uy * to_edge + sy}, classes);
}

class SideView {
 public:
  SideView(const StepFacts& facts, const Wheel& wheel)
      : facts_(facts),
        wheel_(wheel),
        picture_(size, size, "The wheel from the side, in its own frame", description()) {
    low_ = std::min(0.0, wheel.z_min), high_ = wheel.z_max;
    for (const auto& pebble : {facts.pebble_before, facts.pebble_after})
      if (pebble) include(nearby((*pebble)[0]), nearby((*pebble)[2]));
    scale_ = 0.8 * size / std::max({high_ - low_, 2 * side_, 1e-9});
  }

  std::string draw() {
    picture_.rectangle({0, 0}, size, size, "air");
    ground();
    strut();
    pebbles();
    return picture_.finished();
  }

 private:
  static constexpr double size = 420;

  std::string description() const {
    std::string text = fmt::format("From {} to {}. x forward to the right, z down", facts_.from, facts_.to);
    if (facts_.pebble_before)
      text += fmt::format("; pebble at x {:.4g} m, z {:.4g} m", nearby((*facts_.pebble_before)[0]),
                          nearby((*facts_.pebble_before)[2]));
    return text;
  }

  void include(double x, double z) {
    const double reach = 4 * (wheel_.z_max - wheel_.z_min);
    low_ = std::max(std::min(low_, z), low_ - reach), high_ = std::min(std::max(high_, z), high_ + reach);
    side_ = std::max(side_, std::min(std::abs(x), reach));
  }
  Dot pixel(double x, double z) const {
    const auto capped = [](double v) { return std::clamp(v, -2000.0, 2000.0); };
    return {size / 2 + capped(x * scale_), size / 2 + capped((z - (low_ + high_) / 2) * scale_)};
  }
  static Dot in_side(const RationalVector& v) { return {nearby(v[0]), nearby(v[2])}; }

  // The half-plane beyond the plane through the pebble: n points out of the ground.
  void ground() {
    const auto& pebble = facts_.pebble_before ? facts_.pebble_before : facts_.pebble_after;
    if (!pebble || !facts_.normal) return;
    const Dot n = in_side(*facts_.normal);
    const double length = std::hypot(n.x, n.y);
    if (length == 0) return;
    const Dot out{n.x / length, n.y / length};
    const Dot p = pixel(in_side(*pebble).x, in_side(*pebble).y);
    const double far = 3 * size;
    picture_.polygon({{p.x - out.y * far, p.y + out.x * far},
                      {p.x + out.y * far, p.y - out.x * far},
                      {p.x + out.y * far - out.x * far, p.y - out.x * far - out.y * far},
                      {p.x - out.y * far - out.x * far, p.y + out.x * far - out.y * far}},
                     "m0");
  }

  void strut() {
    const Dot top = pixel(0, 0);
    picture_.rectangle({top.x - 40, top.y - 26}, 80, 20, "frame");
    picture_.text({top.x - 46, top.y - 12}, "end", "frame", "halo");
    picture_.line(pixel(0, 0), pixel(0, wheel_.z_max), "strut");
    tick(wheel_.z_min, "z_min: broken above", 0);
    tick(wheel_.z_zero, wheel_.z_zero == wheel_.z_max ? "z_zero = z_max: free below" : "z_zero", 0);
    if (wheel_.z_zero != wheel_.z_max) tick(wheel_.z_max, "z_max: free below", 12);
  }
  void tick(double z, const std::string& words, double shift) {
    const Dot at = pixel(0, z);
    picture_.line({at.x - 12, at.y}, {at.x + 12, at.y}, "strut");
    picture_.text({at.x + 18, at.y + 4 + shift}, "start", words, "halo");
  }

  void pebbles() {
    if (facts_.pebble_after) {
      const Dot at = pixel(in_side(*facts_.pebble_after).x, in_side(*facts_.pebble_after).y);
      picture_.circle(at, 9, "pebble-after");
      if (!facts_.pebble_before) picture_.text({at.x - 14, at.y + 20}, "end", "pebble after", "halo");
    }
    if (!facts_.pebble_before) return;
    const Dot p = in_side(*facts_.pebble_before);
    const Dot at = pixel(p.x, p.y);
    picture_.line(pixel(0, wheel_.z_min), at, "spring");
    const Dot before = in_side(facts_.springs_force), after = in_side(facts_.force_after);
    const double largest = std::max(std::hypot(before.x, before.y), std::hypot(after.x, after.y));
    if (largest > 0) {
      const auto tip = [&](const Dot& f) {
        return Dot{at.x + 90 * f.x / largest, at.y + 90 * f.y / largest};
      };
      picture_.arrow(at, tip(before), "before");
      picture_.arrow(at, tip(after), "after");
    }
    picture_.circle(at, 6, "pebble");
    picture_.text({at.x - 14, at.y + 20}, "end", "pebble", "halo");
  }

  const StepFacts& facts_;
  const Wheel& wheel_;
  Picture picture_;
  double low_ = 0, high_ = 1, side_ = 0, scale_ = 1;
};

bool is_possible(std::string_view from, std::string_view to) {
  if (from == "free" && (to == "slip" || to == "surface gave way")) return false;
  return from != to;
}

}  // namespace

std::string machine_picture(const StepFacts& facts) {
  Picture picture(560, 260, "The wheel's states",
                  fmt::format("This step goes from {} to {}", facts.from, facts.to));
  const Place& from = place_named(facts.from);
  const Place& to = place_named(facts.to);
  for (const char* state : {"free", "stick", "slip"}) {
    for (const Place& other : places) {
      const bool possible = is_possible(state, other.name);
      if (possible) draw_way(picture, place_named(state), other, 6, "way");
    }
  }
  if (&from != &to) draw_way(picture, from, to, 6, "taken");
  for (const Place& place : places) {
    const std::string mark = &place == &to ? "state to" : &place == &from ? "state from" : "state";
    picture.rectangle({place.x - box_width / 2, place.y - box_height / 2}, box_width, box_height, mark);
    picture.text({place.x, place.y + 5}, "middle", place.name, mark == "state" ? "" : "strong");
  }
  if (&from == &to) picture.text({from.x, from.y - 26}, "middle", "stays", "strong halo");
  return picture.finished();
}

std::string side_view(const StepFacts& facts, const Wheel& wheel) { return SideView(facts, wheel).draw(); }

}  // namespace groundtruth::page
