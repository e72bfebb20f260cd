#include <groundtruth/as_written/errata.hpp>

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace groundtruth::as_written {
namespace {

TEST(Errata, EveryNameLeadsBackToItsErratum) {
  std::set<std::string_view> names;
  for (const Erratum erratum : errata_in_order()) {
    EXPECT_EQ(erratum_named(name_of(erratum)), erratum) << name_of(erratum);
    names.insert(name_of(erratum));
  }
  EXPECT_EQ(names.size(), number_of_errata);
}

TEST(Errata, NamesAreThoseOfTheContract) {
  EXPECT_EQ(erratum_named("single-pass-intersection"), Erratum::single_pass_intersection);
  EXPECT_EQ(erratum_named("miss-is-plus-1000"), Erratum::miss_is_plus_1000);
  EXPECT_EQ(erratum_named("frame-rotation-ignored"), Erratum::frame_rotation_ignored);
}

TEST(Errata, RowsThatCannotRunAreNoSwitches) {
  EXPECT_EQ(erratum_named("house-corners"), std::nullopt);
  EXPECT_EQ(erratum_named("mixed-frames"), std::nullopt);
  EXPECT_EQ(erratum_named(""), std::nullopt);
}

TEST(Errata, ASetHasWhatWasPutIntoIt) {
  Errata errata{Erratum::no_liftoff};
  errata.add(Erratum::tensile_contact);
  for (const Erratum erratum : errata_in_order()) {
    const bool is_member = erratum == Erratum::no_liftoff || erratum == Erratum::tensile_contact;
    EXPECT_EQ(errata.has(erratum), is_member) << name_of(erratum);
    EXPECT_TRUE(all_errata().has(erratum)) << name_of(erratum);
  }
}

}  // namespace
}  // namespace groundtruth::as_written
