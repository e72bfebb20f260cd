#pragma once
// Pictures of the friction border and of the wheel's step. Private to this folder.

#include <string>

#include <groundtruth/explanation/explanation.hpp>

namespace groundtruth::page {

// Disc and band in surface coordinates, the regions of the cases, and the force before and after.
std::string clip_picture(const explanation::ClipFacts& facts);

// The states and outcomes, with the way that this step takes.
std::string machine_picture(const explanation::StepFacts& facts);

// Strut, pebble, ground and forces in the wheel's x-z plane.
std::string side_view(const explanation::StepFacts& facts, const Wheel& wheel);

}  // namespace groundtruth::page
