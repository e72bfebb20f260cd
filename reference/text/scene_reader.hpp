#pragma once
// The scene inside a larger document: the inline scenes of ask files.

#include <groundtruth/problem/scene.hpp>
#include <groundtruth/text/field.hpp>

namespace groundtruth {

Scene read_scene(const Field& field);

}  // namespace groundtruth
