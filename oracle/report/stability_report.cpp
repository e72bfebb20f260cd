#include <groundtruth/report/stability_report.hpp>

#include <algorithm>
#include <map>

#include <fmt/format.h>

#include <groundtruth/report/stability_names.hpp>

namespace groundtruth::report {
namespace {

using stability::Cell;
using stability::Fate;
using stability::Ordeal;

char letter_of(const Cell& cell) {
  constexpr char letters[] = {'.', '~', 'c', '#', 'X', '!'};
  return letters[static_cast<std::size_t>(cell.fate)];
}

// Nothing may pass for an explicit limit where the integrator has none.
double limit_of(const Cell& cell) {
  if (cell.parked.integrator == rig::Integrator::implicit) return 1e300;
  return stability::explicit_limit(cell.parked.wheels, cell.parked.damping_ratio);
}

struct Row {
  std::size_t count = 0, ran = 0, not_finite = 0;
  std::map<std::string, std::size_t> reasons;
  double slowest_step_s = 0, border_violation = 0;
};

void add(const Ordeal& ordeal, Row& row) {
  ++row.count;
  if (ordeal.halt == rig::Halt::none)
    ++row.ran;
  else
    ++row.reasons[std::string(rig::name_of(ordeal.halt))];
  if (!ordeal.all_is_finite) ++row.not_finite;
  row.slowest_step_s = std::max(row.slowest_step_s, ordeal.slowest_step_s);
  row.border_violation = std::max(row.border_violation, ordeal.border_violation);
}

}  // namespace

std::string table_of(const stability::Grid& grid, const std::vector<Cell>& cells) {
  const std::size_t columns = grid.h_omegas.size(), rows = grid.damping_ratios.size();
  std::string text;
  for (std::size_t first = 0; first < cells.size(); first += columns * rows) {
    text += fmt::format("{}\n  h omega {:g} ... {:g}\n", panel_name(cells[first].parked),
                        grid.h_omegas.front(), grid.h_omegas.back());
    for (std::size_t row = 0; row < rows; ++row) {
      text += fmt::format("  zeta {:<5g}", grid.damping_ratios[row]);
      bool is_below = true;
      for (std::size_t column = 0; column < columns; ++column) {
        const Cell& cell = cells[first + row * columns + column];
        const bool is_last_below = is_below && cell.parked.h_omega > limit_of(cell);
        if (is_last_below) text += '|';
        is_below = is_below && !is_last_below;
        text += letter_of(cell);
      }
      text += '\n';
    }
  }
  text += ". settled  ~ swinging  c creeping  # chattering  X blown up  ! gave a reason  | the limit\n";
  return text;
}

std::string csv_of(const std::vector<Cell>& cells) {
  std::string text =
      "wheels,integrator,relocation,slope,h_omega,damping_ratio,limit,fate,reason,m_per_hour,energy_rise,"
      "most_newton_steps\n";
  for (const Cell& cell : cells) {
    const stability::Parked& parked = cell.parked;
    const bool is_explicit = parked.integrator != rig::Integrator::implicit;
    text += fmt::format("{},{},{},{},{},{},{},{},{},{},{},{}\n", count_of(parked.wheels),
                        rig::name_of(parked.integrator), name_of(parked.relocation), parked.slope,
                        parked.h_omega, parked.damping_ratio,
                        is_explicit ? fmt::format("{}", limit_of(cell)) : "", stability::name_of(cell.fate),
                        cell.halt == rig::Halt::none ? "" : rig::name_of(cell.halt), cell.metres_per_hour,
                        cell.energy_rise, cell.most_newton_steps);
  }
  return text;
}

std::string table_of(const std::vector<Ordeal>& ordeals) {
  std::vector<std::string> names;
  std::map<std::string, Row> rows;
  for (const Ordeal& ordeal : ordeals) {
    if (rows.find(ordeal.name) == rows.end()) names.push_back(ordeal.name);
    add(ordeal, rows[ordeal.name]);
  }
  std::string text = fmt::format("{:<36}{:>7}{:>7}{:>12}{:>15}{:>17}  stopped because\n", "extreme", "runs",
                                 "ran", "not finite", "slowest step", "beyond border");
  for (const std::string& name : names) {
    const Row& row = rows[name];
    text += fmt::format("{:<36}{:>7}{:>7}{:>12}{:>12.3f} ms{:>17.2g} ", name, row.count, row.ran,
                        row.not_finite, row.slowest_step_s * 1e3, row.border_violation);
    for (const auto& [reason, count] : row.reasons) text += fmt::format(" {} x {}", count, reason);
    text += '\n';
  }
  return text;
}

}  // namespace groundtruth::report
