#pragma once
// The planes of a corner: which leaves share one, and on which sides of them directions are. Not installed.

#include <boost/container/small_vector.hpp>
#include <groundtruth/fast/exact_stage/normal.hpp>

namespace groundtruth::fast::exact_stage {

// Number: one that holds determinants of three normals.
template <class Number>
class Planes {
 public:
  struct Side {
    std::size_t plane;
    int sense;  // 1 if the normal is that of the plane's first leaf, -1 if it is opposite; lengths apart
    bool operator==(const Side&) const = default;
  };

  // Of a leaf with this normal, which is not zero.
  Side add(const Normal<Number>& normal) {
    for (std::size_t plane = 0; plane < normals_.size(); ++plane)
      if (are_parallel(normals_[plane], normal))
        return {plane, have_one_direction(normals_[plane], normal) ? 1 : -1};
    normals_.push_back(normal);
    return {normals_.size() - 1, 1};
  }

  std::size_t size() const { return normals_.size(); }

  // In which one plane cuts another. Requires two planes.
  Normal<Number> line(std::size_t plane, std::size_t other) const {
    return cross(normals_[plane], normals_[other]);
  }

  // The side of `third` on which the directions lie that are just counterclockwise (seen along `plane`'s
  // normal, against it) of line(plane, other): 1 where its normal points to. Lemma turned-directions
  // (proofs-notes/faces.md). Requires that `third` is not `plane`.
  int side_of(const Normal<Number>& line_with_other, std::size_t plane, std::size_t other,
              std::size_t third) const {
    if (third == other) return -1;
    const int along = sign(dot(line_with_other, normals_[third]));
    if (along != 0) return along;
    return have_one_direction(line_with_other, line(plane, third)) ? -1 : 1;
  }

 private:
  static bool are_parallel(const Normal<Number>& a, const Normal<Number>& b) {
    return a[0] * b[1] == a[1] * b[0] && a[1] * b[2] == a[2] * b[1] && a[2] * b[0] == a[0] * b[2];
  }
  // Requires parallel vectors that are not zero.
  static bool have_one_direction(const Normal<Number>& a, const Normal<Number>& b) {
    const std::size_t axis = sign(a[0]) != 0 ? 0 : sign(a[1]) != 0 ? 1 : 2;
    return sign(a[axis]) == sign(b[axis]);
  }

  boost::container::small_vector<Normal<Number>, 8192 / sizeof(Normal<Number>)> normals_;
};

}  // namespace groundtruth::fast::exact_stage
