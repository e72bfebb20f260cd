#pragma once
// How entry asks are made. Each of these makes one of the flavour of its name; see flavour.hpp.

#include <groundtruth/cases/landmarks.hpp>
#include <groundtruth/cases/random.hpp>
#include <groundtruth/problem/ask.hpp>

namespace groundtruth::cases {

EntryAsk entry_random(const Landmarks& landmarks, Random& random);
EntryAsk entry_strut(const Landmarks& landmarks, Random& random);
EntryAsk entry_lattice(const Landmarks& landmarks, Random& random);
EntryAsk entry_from_afar(const Landmarks& landmarks, Random& random);
EntryAsk entry_extreme_bits(const Landmarks& landmarks, Random& random);

EntryAsk entry_through_face(const Landmarks& landmarks, Random& random);
EntryAsk entry_through_edge(const Landmarks& landmarks, Random& random);
EntryAsk entry_through_corner(const Landmarks& landmarks, Random& random);
EntryAsk entry_through_crossing(const Landmarks& landmarks, Random& random);
EntryAsk entry_in_face_plane(const Landmarks& landmarks, Random& random);
EntryAsk entry_along_edge(const Landmarks& landmarks, Random& random);

// In a scene without seams these go through, along and over edges.
EntryAsk entry_across_seam(const Landmarks& landmarks, Random& random);
EntryAsk entry_along_seam(const Landmarks& landmarks, Random& random);
EntryAsk entry_over_seam(const Landmarks& landmarks, Random& random);

EntryAsk entry_start_on_face(const Landmarks& landmarks, Random& random);
EntryAsk entry_start_on_edge(const Landmarks& landmarks, Random& random);
EntryAsk entry_start_on_corner(const Landmarks& landmarks, Random& random);
EntryAsk entry_start_inside(const Landmarks& landmarks, Random& random);
EntryAsk entry_end_on_border(const Landmarks& landmarks, Random& random);
EntryAsk entry_point(const Landmarks& landmarks, Random& random);
EntryAsk entry_instant(const Landmarks& landmarks, Random& random);

}  // namespace groundtruth::cases
