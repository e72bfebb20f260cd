#include <groundtruth/as_written/errata.hpp>

namespace groundtruth::as_written {
namespace {

std::size_t place_of(Erratum erratum) { return static_cast<std::size_t>(erratum); }

}  // namespace

const std::array<Erratum, number_of_errata>& errata_in_order() {
  static constexpr std::array<Erratum, number_of_errata> order{
      Erratum::single_pass_intersection, Erratum::normal_by_order,
      Erratum::miss_is_plus_1000,        Erratum::surface_frame_sign,
      Erratum::band_test_wheel_x,        Erratum::signed_normal_force,
      Erratum::force_on_frame_sign,      Erratum::no_liftoff,
      Erratum::tensile_contact,          Erratum::spring_relocation,
      Erratum::frame_rotation_ignored};
  return order;
}

std::string_view name_of(Erratum erratum) {
  static constexpr std::array<std::string_view, number_of_errata> names{
      "single-pass-intersection", "normal-by-order",     "miss-is-plus-1000",     "surface-frame-sign",
      "band-test-wheel-x",        "signed-normal-force", "force-on-frame-sign",   "no-liftoff",
      "tensile-contact",          "spring-relocation",   "frame-rotation-ignored"};
  return names.at(place_of(erratum));
}

std::optional<Erratum> erratum_named(std::string_view name) {
  for (const Erratum erratum : errata_in_order()) {
    if (name_of(erratum) == name) {
      return erratum;
    }
  }
  return std::nullopt;
}

Errata::Errata(std::initializer_list<Erratum> members) {
  for (const Erratum member : members) {
    add(member);
  }
}

void Errata::add(Erratum erratum) { members_.set(place_of(erratum)); }

bool Errata::has(Erratum erratum) const { return members_.test(place_of(erratum)); }

Errata all_errata() {
  Errata all;
  for (const Erratum erratum : errata_in_order()) {
    all.add(erratum);
  }
  return all;
}

}  // namespace groundtruth::as_written
