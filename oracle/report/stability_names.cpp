#include <groundtruth/report/stability_names.hpp>

#include <fmt/format.h>

namespace groundtruth::report {

int count_of(stability::Wheels wheels) { return wheels == stability::Wheels::one ? 1 : 3; }

std::string_view name_of(Relocation relocation) {
  return relocation == Relocation::spring ? "spring" : "return-mapping";
}

std::string panel_name(const stability::Parked& parked) {
  const int count = count_of(parked.wheels);
  return fmt::format("{}, {} wheel{}, {}", rig::name_of(parked.integrator), count, count == 1 ? "" : "s",
                     name_of(parked.relocation));
}

}  // namespace groundtruth::report
