// motion_tables [implicit|drift|slides]: measures and prints one of the tables, or all. About five minutes.

#include <string_view>

#include <fmt/core.h>

#include <groundtruth/tests/oracle/rig/motion_tables.hpp>

int main(int argc, char** argv) {
  using namespace groundtruth::rig;
  const std::string_view wanted = argc > 1 ? argv[1] : "all";
  const bool wants_all = wanted == "all";
  if (wants_all || wanted == "implicit") print_implicit_table();
  if (wants_all || wanted == "slides") print_slide_and_stop_table();
  if (wants_all || wanted == "drift") print_drift_table();
}
