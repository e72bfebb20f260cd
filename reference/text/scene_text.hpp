#pragma once
// Scenes as text (SPEC section 8).

#include <string>
#include <string_view>

#include <groundtruth/problem/scene.hpp>
#include <groundtruth/text/bad_input.hpp>

namespace groundtruth {

// Throws BadInput, which names file, line and field path ("shape.union[3].halfspace[2]"), on anything that is
// not a scene/1 to the letter: unknown or repeated keys, wrong types, numbers that are not finite doubles,
// integers that no double equals, a material that `materials` lacks, nesting beyond 1,000.
// The sugar `box` comes back as the intersection of its six half-spaces.
Scene read_scene(std::string_view text, const Origin& origin);

// Reads a file. Throws BadInput also if there is none.
Scene read_scene_file(const std::string& file);

// One line of JSON that reads back to the same scene, bit for bit but for -0.
std::string write_scene(const Scene& scene);

}  // namespace groundtruth
