#pragma once
// What a clip does to a force. Not installed.

namespace groundtruth::fast {

// SPEC section 4: stick, and cases 1 to 3 of slip.
enum class Clipping { none, onto_band_edge, onto_corner, onto_circle };

}  // namespace groundtruth::fast
