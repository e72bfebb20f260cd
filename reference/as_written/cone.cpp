#include <groundtruth/as_written/cone.hpp>
#include <groundtruth/as_written/sectors.hpp>
#include <groundtruth/as_written/vector_algebra.hpp>

namespace groundtruth::as_written {
namespace {

// What a leaf comes to, seen from a direction v in the plane of the face asked about. The last two: it has
// that plane itself, and faces the same way or the opposite one.
enum class Seen { everything, nothing, same_way, opposite_way };

// What an expression comes to when its leaves are what is seen: whether it holds at v, a little above the
// plane and a little below it; and whether the face asked about stands in it.
struct View {
  Remains remains = Remains::nothing;
  bool holds = false;
  bool holds_above = false;
  bool holds_below = false;
  bool face_stands = false;
};

constexpr View everything{Remains::everything, true, true, true, false};
constexpr View nothing{Remains::nothing, false, false, false, false};

struct FaceRole {
  bool bounds = false;
  bool solid_nearby = false;  // some open set of directions lies in the cone
};

class ConeView {
 public:
  explicit ConeView(const Cone& cone)
      : cone_(cone), normals_(cone.size()), seen_(cone.size(), Seen::nothing) {
    for (std::size_t part = 0; part < cone.size(); ++part) {
      if (cone[part].operation == Operation::half_space) {
        normals_[part] = scaled_near_one(cone[part].face->half_space.normal);
      }
    }
  }

  FaceRole role_of(std::size_t face) {
    FaceRole role;
    for (const Vector& v : sectors_of_plane(normals_[face], normals_of_other_planes(face))) {
      look_along(v, face);
      const View view = view_of(0, face);
      role.bounds = role.bounds || (view.holds && !view.holds_above && view.face_stands);
      role.solid_nearby = role.solid_nearby || view.holds_above || view.holds_below;
    }
    return role;
  }

 private:
  bool shares_plane(std::size_t part, std::size_t face) const {
    return is_zero(cross(normals_[part], normals_[face]));
  }

  std::vector<Vector> normals_of_other_planes(std::size_t face) const {
    std::vector<Vector> others;
    for (std::size_t part = 0; part < cone_.size(); ++part) {
      if (cone_[part].operation == Operation::half_space && !shares_plane(part, face)) {
        others.push_back(normals_[part]);
      }
    }
    return others;
  }

  void look_along(const Vector& v, std::size_t face) {
    for (std::size_t part = 0; part < cone_.size(); ++part) {
      if (cone_[part].operation != Operation::half_space) {
        continue;
      }
      if (shares_plane(part, face)) {
        seen_[part] = dot(normals_[part], normals_[face]) > 0 ? Seen::same_way : Seen::opposite_way;
      } else {
        seen_[part] = dot(normals_[part], v) <= 0 ? Seen::everything : Seen::nothing;
      }
    }
  }

  View view_of(std::size_t part, std::size_t face) const {
    if (cone_[part].operation != Operation::half_space) {
      return view_of_operands(part, face);
    }
    switch (seen_[part]) {
      case Seen::everything:
        return everything;
      case Seen::nothing:
        return nothing;
      case Seen::same_way:
        return {Remains::some, true, false, true, part == face};
      case Seen::opposite_way:
        return {Remains::some, true, true, false, false};
    }
    return nothing;
  }

  View view_of_operands(std::size_t part, std::size_t face) const {
    const bool is_union = cone_[part].operation == Operation::union_of;
    const View& swallowing = is_union ? everything : nothing;
    View all = is_union ? nothing : everything;
    for (std::size_t operand = part + 1; operand != cone_[part].end; operand = cone_[operand].end) {
      const View one = view_of(operand, face);
      if (one.remains == swallowing.remains) {
        return swallowing;
      }
      all.remains = one.remains == Remains::some ? Remains::some : all.remains;
      all.holds = is_union ? all.holds || one.holds : all.holds && one.holds;
      all.holds_above = is_union ? all.holds_above || one.holds_above : all.holds_above && one.holds_above;
      all.holds_below = is_union ? all.holds_below || one.holds_below : all.holds_below && one.holds_below;
      all.face_stands = all.face_stands || one.face_stands;
    }
    return all;
  }

  const Cone& cone_;
  std::vector<Vector> normals_;  // by part; of half-spaces only
  std::vector<Seen> seen_;       // by part; of half-spaces only
};

}  // namespace

const Node* entered_face(const Cone& cone, const Segment& segment) {
  ConeView view(cone);
  const Node* first_entered = nullptr;
  for (std::size_t part = 0; part < cone.size(); ++part) {
    if (cone[part].operation != Operation::half_space || !segment.entry(cone[part].face->half_space)) {
      continue;
    }
    if (view.role_of(part).bounds) {
      return cone[part].face;
    }
    first_entered = first_entered == nullptr ? cone[part].face : first_entered;
  }
  return first_entered;
}

const Node* start_face(const Cone& cone) {
  ConeView view(cone);
  const Node* first = nullptr;
  bool solid_nearby = false;
  for (std::size_t part = 0; part < cone.size(); ++part) {
    if (cone[part].operation != Operation::half_space) {
      continue;
    }
    const FaceRole role = view.role_of(part);
    if (role.bounds) {
      return cone[part].face;
    }
    solid_nearby = solid_nearby || role.solid_nearby;
    first = first == nullptr ? cone[part].face : first;
  }
  return solid_nearby ? nullptr : first;
}

}  // namespace groundtruth::as_written
