#include <groundtruth/tiers/factories.hpp>

namespace groundtruth::tiers {
namespace {

std::vector<MadeTier> make_tiers() {
  std::vector<MadeTier> made;
  made.push_back(make_float_tier());
  made.push_back(make_double_tier());
  made.push_back(make_engine_tier("as-written", "the source's formulas with all their errors, in doubles"));
  made.push_back(make_engine_tier("fast", "certified doubles, exact integers where they do not suffice"));
  made.push_back(make_long_double_tier());
  made.push_back(make_double_double_tier());
  made.push_back(make_interval_tier());
  made.push_back(make_cpp_bin_float_tier());
  made.push_back(make_mpfr_128_tier());
  made.push_back(make_mpfr_256_tier());
  made.push_back(make_cgal_lazy_tier());
  made.push_back(make_engine_tier("exact", "the reference: rationals (GMP), each answer rounded once"));
  made.push_back(
      make_engine_tier("definition", "the second witness: sorted crossings in Boost's cpp_rational"));
  return made;
}

}  // namespace

AskKind kind_of(const Ask& ask) { return static_cast<AskKind>(ask.index()); }

const std::vector<std::unique_ptr<const Tier>>& tiers() {
  static const std::vector<MadeTier> made = make_tiers();
  return made;
}

std::vector<Row> rows_for(const Scene& scene, const Ask& ask) {
  std::vector<Row> rows;
  for (const auto& tier : tiers()) {
    Row row{tier->name(), tier->description(), Undecided{}};
    if (const auto omission = tier->omission(kind_of(ask)))
      row.said = *omission;
    else
      std::visit([&row](auto&& said) { row.said = std::move(said); }, tier->on(scene)->answer(ask));
    rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace groundtruth::tiers
