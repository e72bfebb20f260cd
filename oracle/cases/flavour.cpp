#include <array>

#include <groundtruth/cases/flavour.hpp>

namespace groundtruth::cases {
namespace {

// In the order of the enumeration.
constexpr std::array<std::string_view, 49> names{
    "entry/random",
    "entry/strut",
    "entry/lattice",
    "entry/through-face",
    "entry/through-edge",
    "entry/through-corner",
    "entry/through-crossing",
    "entry/in-face-plane",
    "entry/along-edge",
    "entry/across-seam",
    "entry/along-seam",
    "entry/over-seam",
    "entry/start-on-face",
    "entry/start-on-edge",
    "entry/start-on-corner",
    "entry/start-inside",
    "entry/end-on-border",
    "entry/point",
    "entry/instant",
    "entry/from-afar",
    "entry/extreme-bits",
    "clip/random",
    "clip/disc-border",
    "clip/band-edge",
    "clip/border-corner",
    "clip/case-border-1-2",
    "clip/case-border-2-3",
    "clip/wide-band",
    "clip/zeros",
    "clip/steepness-limit",
    "clip/hopeless-surface",
    "clip/extreme-bits",
    "step/free-hit",
    "step/free-miss",
    "step/free-limits",
    "step/free-in-ground",
    "step/resting",
    "step/skidding",
    "step/turning",
    "step/over-the-edge",
    "step/lands-on-feature",
    "step/z-limits",
    "step/no-pressure",
    "step/gives-way",
    "step/border",
    "step/steepness-limit",
    "step/stiff",
    "step/unknown-tyre",
    "step/extreme-bits",
};

}  // namespace

std::string_view name(Flavour flavour) { return names[static_cast<std::size_t>(flavour)]; }

const std::vector<Flavour>& all_flavours() {
  static const std::vector<Flavour> flavours = [] {
    std::vector<Flavour> all;
    for (std::size_t i = 0; i < names.size(); ++i) all.push_back(static_cast<Flavour>(i));
    return all;
  }();
  return flavours;
}

}  // namespace groundtruth::cases
