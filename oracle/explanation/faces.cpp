#include <groundtruth/explanation/faces.hpp>

#include <algorithm>

namespace groundtruth::explanation {
namespace {

RationalVector plus(const RationalVector& a, const RationalVector& b) { return along(a, 1, b); }

// The cone L of SPEC section 3: the planes through the point, the others as constants.
class Cone {
 public:
  Cone(const Solid& solid, const RationalVector& point) : solid_(solid) {
    for (const Plane& plane : solid.planes) {
      heights_.push_back(plane.height(point).sign());
      if (heights_.back() == 0 && plane.is_a_plane()) tied_.push_back(heights_.size() - 1);
    }
  }

  const std::vector<std::size_t>& tied() const { return tied_; }
  const RationalVector& normal(std::size_t plane) const { return solid_.planes[plane].normal; }
  bool are_parallel(std::size_t a, std::size_t b) const {
    return cross(normal(a), normal(b)) == RationalVector{};
  }

  std::vector<bool> standing() const {
    return explanation::standing(solid_, [this](std::size_t plane) { return of_untied(plane); });
  }

  // The cone at v + step n, n the normal of `through`, in whose plane v lies; step is -1, 0 or +1 times a
  // small number.
  bool holds(const RationalVector& v, std::size_t through, int step) const {
    return evaluate(solid_, [&](std::size_t plane) {
             if (!is_tied(plane)) return of_untied(plane);
             int side = dot(normal(plane), v).sign();
             if (side == 0) side = step * dot(normal(plane), normal(through)).sign();
             return side <= 0 ? Truth::yes : Truth::no;
           }) == Truth::yes;
  }

  // Whether `through` still stands where every leaf of another plane has its value at v.
  bool stands_at(const RationalVector& v, std::size_t through) const {
    return explanation::standing(solid_, [&](std::size_t plane) {
      if (!is_tied(plane)) return of_untied(plane);
      if (are_parallel(plane, through)) return Truth::unknown;
      return dot(normal(plane), v).sign() <= 0 ? Truth::yes : Truth::no;
    })[through];
  }

  // Directions in the plane of `through`, at least one in each sector into which the other planes cut it.
  std::vector<RationalVector> sectors_of(std::size_t through) const {
    std::vector<RationalVector> rays;
    for (const std::size_t other : tied_) {
      const RationalVector ray = cross(normal(through), normal(other));
      if (ray == RationalVector{}) continue;
      rays.push_back(ray);
      rays.push_back(minus({}, ray));
    }
    if (rays.empty()) return {{}};
    std::vector<RationalVector> directions;
    for (const RationalVector& ray : rays) directions.push_back(cross(normal(through), ray));
    for (std::size_t i = 0; i < rays.size(); ++i)
      for (std::size_t j = i + 1; j < rays.size(); ++j) directions.push_back(plus(rays[i], rays[j]));
    std::erase_if(directions, [&](const RationalVector& v) { return !is_generic(v, through); });
    return directions;
  }

 private:
  bool is_tied(std::size_t plane) const { return heights_[plane] == 0 && solid_.planes[plane].is_a_plane(); }
  Truth of_untied(std::size_t plane) const {
    if (is_tied(plane)) return Truth::unknown;
    return heights_[plane] <= 0 ? Truth::yes : Truth::no;
  }
  bool is_generic(const RationalVector& v, std::size_t through) const {
    return std::all_of(tied_.begin(), tied_.end(), [&](std::size_t other) {
      return are_parallel(other, through) || dot(normal(other), v) != 0;
    });
  }

  const Solid& solid_;
  std::vector<int> heights_;
  std::vector<std::size_t> tied_;
};

// Of a leaf that stands, whether or not it is entered.
Role role_in(const Cone& cone, std::size_t plane) {
  bool touches = false, has_facet = false;
  for (const RationalVector& v : cone.sectors_of(plane)) {
    if (!cone.holds(v, plane, 0)) continue;
    touches = true;
    if (cone.holds(v, plane, +1)) continue;
    has_facet = true;
    if (cone.stands_at(v, plane)) return Role::admissible;
  }
  if (has_facet) return Role::stood_in_for;
  return touches ? Role::behind : Role::apart;
}

bool any_bounds(const std::vector<TiedFace>& faces) {
  return std::any_of(faces.begin(), faces.end(), [](const TiedFace& face) {
    return face.role == Role::admissible || face.role == Role::not_entered || face.role == Role::stood_in_for;
  });
}

// Without a facet in any plane's sectors: is every neighbourhood inside? Then so is some sector of each
// plane.
bool is_interior(const Cone& cone, const std::vector<TiedFace>& faces) {
  if (any_bounds(faces)) return false;
  for (const std::size_t plane : cone.tied()) {
    for (const RationalVector& v : cone.sectors_of(plane))
      if (!cone.holds(v, plane, 0)) return false;
  }
  return true;
}

}  // namespace

Meeting meeting_at(const Solid& solid, const Arrival& arrival) {
  const Cone cone(solid, arrival.point);
  const std::vector<bool> stands = cone.standing();
  Meeting meeting;
  for (const std::size_t plane : cone.tied()) {
    TiedFace face{plane, Role::swallowed, dot(cone.normal(plane), arrival.direction).sign() < 0};
    if (stands[plane]) face.role = role_in(cone, plane);
    meeting.faces.push_back(face);
  }
  meeting.interior = is_interior(cone, meeting.faces);
  if (meeting.interior) return meeting;
  const auto counts = [&](const TiedFace& face) { return arrival.at_start || face.entered; };
  for (TiedFace& face : meeting.faces)
    if (face.role == Role::admissible && !counts(face)) face.role = Role::not_entered;
  const bool none = std::none_of(meeting.faces.begin(), meeting.faces.end(),
                                 [](const TiedFace& face) { return face.role == Role::admissible; });
  if (!none) return meeting;
  for (TiedFace& face : meeting.faces)
    if (stands[face.plane]) face.role = counts(face) ? Role::thin : Role::not_needed;
  return meeting;
}

std::string_view reason_of(Role role) {
  switch (role) {
    case Role::admissible:
      return "bounds the solid here and the segment comes in through it";
    case Role::thin:
      return "the solid is thinner than a face here, so any face the segment enters may be named";
    case Role::behind:
      return "the solid goes on behind it: a seam, not a face";
    case Role::apart:
      return "the solid does not lie along this plane near the point";
    case Role::stood_in_for:
      return "another leaf with the same plane is the face here";
    case Role::swallowed:
      return "the other leaves decide here without it";
    case Role::not_entered:
      return "bounds the solid here, but the segment does not go into its half-space";
    case Role::not_needed:
      return "the segment does not go into its half-space";
  }
  return "";
}

}  // namespace groundtruth::explanation
