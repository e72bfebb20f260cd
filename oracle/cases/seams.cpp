#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include <groundtruth/cases/seams.hpp>

namespace groundtruth::cases {
namespace {

using Key = std::array<double, 4>;

struct Place {
  std::size_t piece = 0;
  std::size_t plane = 0;
};

constexpr std::ptrdiff_t reach = 64;  // in places that share a plane

// Adding zero turns -0 into 0.
Key key_of(const HalfSpace& plane) {
  return {plane.normal[0] + 0.0, plane.normal[1] + 0.0, plane.normal[2] + 0.0, plane.offset + 0.0};
}

Key opposite(const Key& key) { return {0 - key[0], 0 - key[1], 0 - key[2], 0 - key[3]}; }

bool touch(const PieceBounds& a, const PieceBounds& b) {
  for (std::size_t i = 0; i < 3; ++i) {
    if (a.high[i] < b.low[i] || b.high[i] < a.low[i]) return false;
  }
  return true;
}

bool is_bounded(const PieceBounds& bounds) { return std::isfinite(bounds.low[0]); }

}  // namespace

std::vector<Seam> find_seams(const std::vector<Piece>& pieces, const std::vector<PieceBounds>& bounds) {
  std::map<Key, std::vector<Place>> places;
  for (std::size_t piece = 0; piece < pieces.size(); ++piece) {
    for (std::size_t plane = 0; plane < pieces[piece].size(); ++plane) {
      places[key_of(pieces[piece][plane])].push_back({piece, plane});
    }
  }
  std::vector<Seam> seams;
  for (const auto& [key, ours] : places) {
    const auto found = places.find(opposite(key));
    if (found == places.end()) continue;
    const std::vector<Place>& theirs = found->second;
    for (const Place& place : ours) {
      const auto middle = std::lower_bound(theirs.begin(), theirs.end(), place,
                                           [](const Place& a, const Place& b) { return a.piece < b.piece; });
      const auto first = middle - std::min(reach, middle - theirs.begin());
      const auto last = middle + std::min(reach, theirs.end() - middle);
      for (auto other = first; other != last; ++other) {
        const PieceBounds& our_bounds = bounds[place.piece];
        const PieceBounds& their_bounds = bounds[other->piece];
        if (other->piece == place.piece || !touch(our_bounds, their_bounds)) continue;
        // The corners of a seam are those of its bounded side.
        if (!is_bounded(our_bounds) && is_bounded(their_bounds)) continue;
        seams.push_back({place.piece, place.plane, other->piece});
      }
    }
  }
  return seams;
}

}  // namespace groundtruth::cases
