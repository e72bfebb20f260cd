#pragma once
// The materials of all scenes built into the program, for the tyres "rubber" and "metal".

#include <vector>

#include <groundtruth/problem/scene.hpp>

namespace groundtruth::cases {

inline constexpr MaterialIndex dry = 0;
inline constexpr MaterialIndex wet = 1;
inline constexpr MaterialIndex icy = 2;
inline constexpr MaterialIndex dirty = 3;  // gives way under 20 kN
inline constexpr MaterialIndex water = 4;  // gives way under any force
inline constexpr MaterialIndex glass = 5;  // has no friction for rubber: such a contact is refused

// In the order of the indices above. Rubber has the coefficients of SPEC section 2.
std::vector<Material> ground_materials();

}  // namespace groundtruth::cases
