#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include <groundtruth/tiers/factories.hpp>
#include <groundtruth/tiers/naive/naive_tier.hpp>

namespace groundtruth::tiers {

using LazyExact = CGAL::Epeck::FT;

namespace naive {

template <>
struct Arithmetic<LazyExact> {
  static constexpr bool has_roots = false;
  // Of the rational: the lazy bounds alone may be 10^-5 wide. CGAL promises a double near it, not the nearest.
  static double nearest_double(const LazyExact& value) { return CGAL::to_double(CGAL::exact(value)); }
};

}  // namespace naive

MadeTier make_cgal_lazy_tier() {
  return std::make_unique<naive::NaiveTier<LazyExact>>(
      "cgal-lazy",
      "plain recursion in CGAL's lazy exact numbers: intervals first, rationals where they fail");
}

}  // namespace groundtruth::tiers
