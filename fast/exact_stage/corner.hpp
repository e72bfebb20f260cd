#pragma once
// Which of the faces of a solid counts at a point of its border (SPEC section 3). Not installed.

#include <optional>

#include <groundtruth/fast/exact_stage/near_point.hpp>

namespace groundtruth::fast::exact_stage {

// How the range comes to the point.
enum class Arrival : std::uint8_t { starts_there, enters_there };

// The place of the canonical leaf of a solid that contains the point; nothing: it lies in the interior.
// 1. In machine integers where the normals' components take some 20 bits, in two or four times as long ones
//    where they take 41 or 84, else in integers as long as need be.
// 2. One look a face, at up to 64 directions at a time, until one bounds: about leaves + planes^2 each.
// Requires, of a point where the range enters, that some leaf that stands is entered.
std::optional<std::size_t> canonical_leaf(const ExpressionView& solid, const LeavesNearPoint& near,
                                          Arrival arrival);

}  // namespace groundtruth::fast::exact_stage
