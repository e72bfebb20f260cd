#include "cut.hpp"

#include <algorithm>
#include <cmath>

namespace groundtruth::page {
namespace {

using namespace explanation;

double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vector combined(double s, const Vector& a, double t, const Vector& b) {
  return {s * a[0] + t * b[0], s * a[1] + t * b[1], s * a[2] + t * b[2]};
}
Vector unit(const Vector& v) {
  const double size = std::hypot(v[0], v[1], v[2]);
  return size > 0 ? combined(1 / size, v, 0, v) : v;
}
Vector in_doubles(const RationalVector& v) {
  // Only the direction counts: out of reach of overflow.
  Rational largest = 0;
  for (const Rational& one : v) largest = std::max(largest, Rational(abs(one)));
  if (largest == 0) return {};
  return unit({nearby(v[0] / largest), nearby(v[1] / largest), nearby(v[2] / largest)});
}

// What of these, orthogonal to `d`, is largest.
Vector most_across(const Vector& d, const std::vector<Vector>& candidates) {
  Vector best{};
  double largest = 0.05;
  for (const Vector& candidate : candidates) {
    const Vector across = combined(1, candidate, -dot(candidate, d), d);
    const double size = std::hypot(across[0], across[1], across[2]);
    if (size <= largest) continue;
    largest = size;
    best = unit(across);
  }
  return best;
}

std::vector<Dot> clipped(const std::vector<Dot>& polygon, const Trace& trace) {
  std::vector<Dot> result;
  const auto height = [&](const Dot& p) { return trace.a * p.x + trace.b * p.y + trace.c; };
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Dot& here = polygon[i];
    const Dot& next = polygon[(i + 1) % polygon.size()];
    const double h = height(here), k = height(next);
    if (h <= 0) result.push_back(here);
    if ((h < 0 && k > 0) || (h > 0 && k < 0)) {
      const double t = h / (h - k);
      result.push_back({here.x + t * (next.x - here.x), here.y + t * (next.y - here.y)});
    }
  }
  return result;
}

std::vector<Dot> corners_of(const Window& window) {
  const double w = window.half_width, h = window.half_height;
  return {{-w, -h}, {w, -h}, {w, h}, {-w, h}};
}

double area(const std::vector<Dot>& polygon) {
  double twice = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Dot& p = polygon[i];
    const Dot& q = polygon[(i + 1) % polygon.size()];
    twice += p.x * q.y - q.x * p.y;
  }
  return std::abs(twice) / 2;
}

// Cuts the window by one plane after the other until the expression is constant in each cell.
class Cutting {
 public:
  Cutting(const Solid& solid, const CutPlane& cut, const Window& window)
      : solid_(solid), cut_(cut), window_(window), truth_(solid.planes.size(), Truth::unknown) {
    for (const Plane& plane : solid.planes) traces_.push_back(trace_of(plane, cut, window.centre));
    least_area_ = 1e-7 * window.half_width * window.half_height;
    divide(corners_of(window), 0);
  }
  std::vector<Cell> take() && { return std::move(cells_); }

 private:
  void divide(const std::vector<Dot>& cell, std::size_t place) {
    if (cell.size() < 3 || area(cell) < least_area_) return;
    const Truth truth = evaluate(solid_, [this](std::size_t plane) { return truth_[plane]; });
    if (truth == Truth::yes) cells_.push_back({cell, material_in(cell)});
    if (truth != Truth::unknown) return;
    const Trace& trace = traces_[place];
    truth_[place] = Truth::yes;
    divide(clipped(cell, trace), place + 1);
    truth_[place] = Truth::no;
    divide(clipped(cell, {-trace.a, -trace.b, -trace.c}), place + 1);
    truth_[place] = Truth::unknown;
  }

  std::optional<MaterialIndex> material_in(const std::vector<Dot>& cell) const {
    Dot middle;
    for (const Dot& corner : cell) {
      middle.x += corner.x / static_cast<double>(cell.size());
      middle.y += corner.y / static_cast<double>(cell.size());
    }
    const RationalVector across = rational(cut_.across), up = rational(cut_.up);
    const RationalVector point =
        along(along(window_.centre, Rational(middle.x), across), Rational(middle.y), up);
    return material_of(0, point);
  }

  // The coat of the first part that holds.
  std::optional<MaterialIndex> material_of(std::size_t at, const RationalVector& point) const {
    const Node& node = solid_.nodes[at];
    if (node.part == Part::covered) return node.material;
    if (node.part == Part::painted && contains(*node.where, point)) return node.material;
    for (std::size_t operand = at + 1; operand < node.end; operand = solid_.nodes[operand].end) {
      if (!holds(operand)) continue;
      if (const auto material = material_of(operand, point)) return material;
    }
    return std::nullopt;
  }
  bool holds(std::size_t at) const {
    Solid part;
    const std::size_t end = std::max(solid_.nodes[at].end, at + 1);
    for (std::size_t i = at; i < end; ++i) {
      part.nodes.push_back(solid_.nodes[i]);
      part.nodes.back().end -= at;
    }
    return evaluate(part, [this](std::size_t plane) { return truth_[plane]; }) == Truth::yes;
  }

  const Solid& solid_;
  const CutPlane& cut_;
  const Window& window_;
  std::vector<Trace> traces_;
  std::vector<Truth> truth_;
  std::vector<Cell> cells_;
  double least_area_ = 0;
};

}  // namespace

CutPlane cut_through(const EntryFacts& facts) {
  Vector d = in_doubles(facts.segment.direction);
  std::vector<Vector> candidates;
  for (const TiedFace& face : facts.decision.meeting.faces)
    candidates.push_back(in_doubles(facts.in_play.planes[face.plane].normal));
  if (d == Vector{}) d = candidates.empty() ? Vector{0, 0, 1} : candidates.front();
  Vector side = most_across(d, candidates);
  if (side == Vector{}) side = most_across(d, {{0, 0, 1}});
  if (side == Vector{}) side = most_across(d, {{1, 0, 0}, {0, 1, 0}});
  // The world's z within the plane is up, if there is enough of it.
  const Vector z = combined(d[2], d, side[2], side);
  if (std::hypot(z[0], z[1], z[2]) < 0.1) return {d, side};
  const Vector up = unit(z);
  Vector across = combined(dot(up, side), d, -dot(up, d), side);
  const double sense = std::abs(across[0]) > 1e-9 ? across[0] : across[1];
  if (sense < 0) across = combined(-1, across, 0, across);
  return {across, up};
}

Trace trace_of(const Plane& plane, const CutPlane& cut, const RationalVector& centre) {
  const Vector normal = in_doubles(plane.normal);
  const Rational squared = explanation::dot(plane.normal, plane.normal);
  const Rational height = plane.height(centre);
  const double distance = squared == 0 ? 0 : nearby_root(height * height / squared);
  return {dot(normal, cut.across), dot(normal, cut.up), height < 0 ? -distance : distance};
}

std::vector<Cell> cells_of(const Solid& solid, const CutPlane& cut, const Window& window) {
  return Cutting(solid, cut, window).take();
}

std::vector<Dot> piece_of(const Trace& trace, const Window& window) {
  std::vector<Dot> ends;
  const std::vector<Dot> corners = corners_of(window);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Dot& p = corners[i];
    const Dot& q = corners[(i + 1) % corners.size()];
    const double h = trace.a * p.x + trace.b * p.y + trace.c;
    const double k = trace.a * q.x + trace.b * q.y + trace.c;
    if ((h <= 0) == (k <= 0)) continue;
    const double t = h / (h - k);
    ends.push_back({p.x + t * (q.x - p.x), p.y + t * (q.y - p.y)});
  }
  return ends.size() == 2 ? ends : std::vector<Dot>{};
}

}  // namespace groundtruth::page
