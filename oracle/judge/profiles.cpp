#include <algorithm>

#include <groundtruth/judge/verdict.hpp>

namespace groundtruth::judge {

// Derivation of the figures: proofs-notes/tolerance.md, 5.
const std::vector<Profile>& profiles() {
  static const std::vector<Profile> all = {
      {"exact",
       "every decision exact, lambda the nearest double or its neighbour, vectors to 1e-12, normals as "
       "doubles normalise them",
       {0, 1, 0x1p-50, 0, 1e-12, Faces::any_admissible}},
      {"double",
       "careful double arithmetic: 1 nm, 1e-9 of the scale of a decision or of a vector's terms",
       {1e-9, 4, 1e-12, 1e-9, 1e-9, Faces::any_admissible}},
      {"float",
       "careful float arithmetic within a few hundred metres: 0.1 mm, 1e-4, 0.01 degrees",
       {1e-4, 0x1p+31, 2e-4, 1e-4, 1e-4, Faces::any_admissible}},
      {"game",
       "what nobody sees: 1 mm, one in a thousand, 2 degrees",
       {1e-3, 0x1p+33, 0.035, 1e-3, 1e-3, Faces::any_admissible}}};
  return all;
}

const Profile* find_profile(std::string_view name) {
  const auto found = std::find_if(profiles().begin(), profiles().end(),
                                  [&](const Profile& profile) { return profile.name == name; });
  return found == profiles().end() ? nullptr : &*found;
}

}  // namespace groundtruth::judge
