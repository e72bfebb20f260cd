#pragma once
// The pebble borders that a tolerance allows. Private to this folder.

#include <array>

namespace groundtruth::judge {

struct BorderNumbers {
  double friction = 0;
  double brake = 0;  // N
};

// The four borders whose mu N and B lie `change` newtons to either side, never below 0: first both grown,
// then both shrunk, then one of each. `pressing` is N. Where no mu makes mu N that large, the largest double.
std::array<BorderNumbers, 4> borders_around(const BorderNumbers& border, long double pressing,
                                            long double change);

}  // namespace groundtruth::judge
