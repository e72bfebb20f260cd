#pragma once
// The source's Q(n): an orientation on the surface.

#include <optional>

#include <groundtruth/as_written/errata.hpp>
#include <groundtruth/as_written/vector_algebra.hpp>

namespace groundtruth::as_written {

// The axes of the surface in wheel coordinates: x where the wheel rolls, z into the ground (with
// Erratum::surface_frame_sign, not so). Nothing if the surface is too steep for that, in rounded arithmetic,
// so that a surface just at the limit may be taken for either.
std::optional<Axes> surface_frame(const Vector& normal_in_wheel, double min_uprightness,
                                  const Errata& errata);

}  // namespace groundtruth::as_written
