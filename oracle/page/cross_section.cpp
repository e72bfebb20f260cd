#include "cross_section.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include <fmt/format.h>

#include "cut.hpp"
#include "words.hpp"

namespace groundtruth::page {
namespace {

using namespace explanation;

constexpr double width = 640, height = 420;

double unit_in_last_place(double lambda) {
  const double size = lambda == 0 ? 1 : std::abs(lambda);
  return std::nextafter(size, std::numeric_limits<double>::infinity()) - size;
}

class Section {
 public:
  Section(const EntryFacts& facts, double lambda)
      : facts_(facts),
        lambda_(lambda),
        cut_(cut_through(facts)),
        metres_(nearby_root(dot(facts.segment.direction, facts.segment.direction))),
        picture_(width, height, "Cross-section through the segment", description()) {
    const Segment& segment = facts.segment;
    const Rational middle = (segment.first + segment.last) / 2;
    centre_lambda_ = facts.decision.lambda.value_or(middle);
    for (const Flip& flip : facts.search.flips)
      if (!facts.decision.lambda && flip.becomes.lambda) centre_lambda_ = *flip.becomes.lambda;
    heading_ = heading();
  }

  CrossSection draw() {
    CrossSection result;
    const double range = std::abs(nearby(facts_.segment.last - facts_.segment.first)) * metres_;
    const double whole = range > 0 ? 1.25 * range : 2;
    const double ulp = unit_in_last_place(lambda_) * (metres_ > 0 ? metres_ : 1);
    const double closest = 24 * ulp;
    const int steps = closest < whole / 4 ? 4 : 0;
    for (int step = 0; step <= steps; ++step) {
      const double across = step == 0 ? whole * 1.2 : whole * std::pow(closest / whole, step / 4.0);
      draw_zoom(across, step, ulp);
      result.zooms.push_back(fmt::format("{} {:.3g} m across, {:.3g} ulps of lambda",
                                         step == 0 ? "All:" : "Close:", across, across / ulp));
    }
    result.picture = picture_.finished();
    for (const Stop& stop : facts_.stops)
      result.stops.push_back(nearby(Rational((stop.from + stop.to) / 2 - centre_lambda_)) * metres_);
    result.materials.assign(materials_.begin(), materials_.end());
    return result;
  }

 private:
  std::string description() const {
    std::string text = facts_.decision.lambda ? fmt::format("The segment enters at lambda {}",
                                                            write_fraction(*facts_.decision.lambda))
                                              : "The segment misses the solid";
    for (const TiedFace& face : facts_.decision.meeting.faces)
      text += fmt::format("; leaf {}: {}", facts_.in_play.planes[face.plane].leaf,
                          facts_.decision.meeting.is_admissible(face) ? "a face" : "no face");
    return text;
  }

  // Of the segment in the picture, y downwards; one over the length.
  Dot heading() const {
    if (metres_ == 0) return {0, 0};
    const auto part = [&](const Vector& axis) {
      return nearby(dot(facts_.segment.direction, rational(axis))) / metres_;
    };
    return {part(cut_.across), -part(cut_.up)};
  }

  void draw_zoom(double across, int step, double ulp) {
    const double scale = height / across;
    Window window;
    const Rational middle = (facts_.segment.first + facts_.segment.last) / 2;
    const Rational centre = step == 0 ? middle : centre_lambda_;
    window.centre = facts_.segment.at(centre);
    window.half_height = across / 2;
    window.half_width = across / 2 * width / height;
    const double shift = nearby(Rational(centre_lambda_ - centre)) * metres_;
    const auto pixel = [&](Dot p) { return Dot{width / 2 + p.x * scale, height / 2 - p.y * scale}; };
    const auto along_segment = [&](double metres) {
      return Dot{width / 2 + heading_.x * (metres + shift) * scale,
                 height / 2 + heading_.y * (metres + shift) * scale};
    };
    picture_.open_group(fmt::format(
        "class=\"zoom\"{} data-x=\"{:.2f}\" data-y=\"{:.2f}\" data-dx=\"{:.17g}\" data-dy=\"{:.17g}\"",
        step == 0 ? "" : " hidden=\"hidden\"", along_segment(0).x, along_segment(0).y, heading_.x * scale,
        heading_.y * scale));
    picture_.rectangle({0, 0}, width, height, "air");
    for (const Cell& cell : cells_of(facts_.in_play, cut_, window)) {
      std::vector<Dot> corners;
      for (const Dot& corner : cell.corners) corners.push_back(pixel(corner));
      picture_.polygon(corners, class_of(cell.material));
      materials_.insert(cell.material);
    }
    draw_planes(window, pixel);
    const double from = nearby(Rational(facts_.segment.first - centre_lambda_)) * metres_;
    const double to = nearby(Rational(facts_.segment.last - centre_lambda_)) * metres_;
    const double far = 3 * across;
    picture_.arrow(along_segment(std::max(from, -far)), along_segment(std::min(to, far)), "segment");
    if (from > -far) picture_.circle(along_segment(from), 4, "start");
    if (step == 4) draw_doubles(ulp, along_segment);
    if (facts_.decision.lambda) picture_.circle(along_segment(0), 6, "hit");
    picture_.circle(along_segment(0), 9, "cursor");
    picture_.close_group();
  }

  std::string class_of(const std::optional<MaterialIndex>& material) const {
    return material ? fmt::format("m{}", *material % 6) : "m-none";
  }

  template <typename Pixel>
  void draw_planes(const Window& window, const Pixel& pixel) {
    std::set<std::size_t> tied;
    for (const TiedFace& face : facts_.decision.meeting.faces) tied.insert(face.plane);
    for (std::size_t place = 0; place < facts_.in_play.planes.size(); ++place) {
      if (tied.contains(place)) continue;
      const auto ends = piece_of(trace_of(facts_.in_play.planes[place], cut_, window.centre), window);
      if (ends.size() == 2) picture_.line(pixel(ends[0]), pixel(ends[1]), "plane");
    }
    double step = 0;
    for (const TiedFace& face : facts_.decision.meeting.faces) {
      const Plane& plane = facts_.in_play.planes[face.plane];
      const auto ends = piece_of(trace_of(plane, cut_, window.centre), window);
      if (ends.size() != 2) continue;
      const bool may = facts_.decision.meeting.is_admissible(face);
      const Dot p = pixel(ends[0]), q = pixel(ends[1]);
      picture_.line(p, q, may ? "tied face" : "tied seam");
      const double t = p.x > q.x || (p.x == q.x && p.y > q.y) ? 0.03 + step : 0.97 - step;
      const Dot at{p.x + t * (q.x - p.x), p.y + t * (q.y - p.y)};
      const bool right = at.x > width / 2;
      picture_.text({at.x + (right ? -6 : 6), std::clamp(at.y - 6, 16.0, height - 6)},
                    right ? "end" : "start", fmt::format("leaf {}{}", plane.leaf, may ? ": face" : ""),
                    "halo");
      step += 0.09;
    }
  }

  // The doubles around lambda: where an answer could lie at all.
  template <typename AlongSegment>
  void draw_doubles(double ulp, const AlongSegment& along_segment) {
    if (metres_ == 0) return;
    const double nearest = nearby(Rational(Rational(lambda_) - centre_lambda_)) * metres_;
    for (int k = -12; k <= 12; ++k) {
      const Dot at = along_segment(nearest + k * ulp);
      const double reach = k == 0 ? 12 : 6;
      const Dot side{-heading_.y * reach, heading_.x * reach};
      picture_.line({at.x - side.x, at.y - side.y}, {at.x + side.x, at.y + side.y},
                    k == 0 ? "nearest" : "double");
    }
  }

  const EntryFacts& facts_;
  double lambda_;
  CutPlane cut_;
  double metres_;
  Picture picture_;
  Rational centre_lambda_;
  Dot heading_;
  std::set<std::optional<MaterialIndex>> materials_;
};

}  // namespace

CrossSection cross_section_of(const EntryFacts& facts, double lambda) {
  return Section(facts, lambda).draw();
}

}  // namespace groundtruth::page
