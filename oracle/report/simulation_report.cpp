#include <groundtruth/report/simulation_report.hpp>

#include <cmath>

#include <fmt/format.h>
#include <rapidjson/stringbuffer.h>
#include <rapidjson/writer.h>

namespace groundtruth::report {
namespace {

using rig::Halt;

std::string outcome_in_words(const rig::Summary& summary) {
  switch (summary.outcome) {
    case Halt::none:
      return "ran to its end";
    case Halt::wheel_broken:
      return fmt::format("wheel {} broke: its strut was compressed to its end", summary.halting_wheel);
    case Halt::surface_too_steep:
      return fmt::format("the surface under wheel {} is too steep", summary.halting_wheel);
    case Halt::surface_gave_way:
      return fmt::format("the ground gave way under wheel {}", summary.halting_wheel);
    case Halt::refused:
      return fmt::format("the step of wheel {} was refused: {}", summary.halting_wheel, summary.reason);
    case Halt::not_finite:
      return "a number left the range of doubles";
    case Halt::not_solved:
      return "the implicit step found no forces that agree with its motion";
  }
  return {};
}

std::string recurrence_in_words(const rig::Summary& summary) {
  if (!summary.recurrence) return {};
  const auto& [seen, period] = *summary.recurrence;
  return fmt::format("; from step {} on it repeats itself every {} step{}, to the last bit", seen - period,
                     period, period == 1 ? "" : "s");
}

}  // namespace

std::string table_of(const rig::Scenario& scenario, const rig::Summary& summary) {
  std::string text = fmt::format("{}: {}\n", scenario.name, scenario.description);
  const auto row = [&](const char* what, const std::string& value) {
    text += fmt::format("  {:<18}{}\n", what, value);
  };
  row("played", fmt::format("{:.6g} s in {} steps of {:.6g} s, {}", summary.duration_s, summary.steps,
                            scenario.h, rig::name_of(scenario.integrator)));
  row("drift, last half",
      fmt::format("body {:.6g} m, pebble {:.6g} m", summary.body_drift_m, summary.pebble_drift_m));
  row("energy rise", fmt::format("at most {:.3g} of m g 1 m in a step", summary.energy_rise));
  row("border violation", fmt::format("at most {:.3g} of the load", summary.border_violation));
  row("wheel steps", fmt::format("{} free, {} stick, {} slip", summary.wheel_steps_free,
                                 summary.wheel_steps_stick, summary.wheel_steps_slip));
  if (scenario.integrator == rig::Integrator::implicit)
    row("solver", fmt::format("at most {} Newton steps, {} convex passes in a step",
                              summary.most_newton_steps, summary.most_convex_passes));
  row("outcome", outcome_in_words(summary) + recurrence_in_words(summary));
  return text;
}

std::string json_of(const rig::Scenario& scenario, const rig::Summary& summary) {
  rapidjson::StringBuffer buffer;
  rapidjson::Writer<rapidjson::StringBuffer> writer(buffer);
  const auto text = [&](const char* key, std::string_view value) {
    writer.Key(key);
    writer.String(value.data(), static_cast<rapidjson::SizeType>(value.size()));
  };
  const auto count = [&](const char* key, std::uint64_t value) { writer.Key(key), writer.Uint64(value); };
  // JSON has no infinity: a pebble that came or went is at no distance.
  const auto number = [&](const char* key, double value) {
    writer.Key(key);
    std::isfinite(value) ? writer.Double(value) : writer.Null();
  };
  writer.StartObject();
  text("scenario", scenario.name);
  text("integrator", rig::name_of(scenario.integrator));
  number("h", scenario.h);
  number("duration_s", summary.duration_s);
  count("steps", summary.steps);
  number("body_drift_m", summary.body_drift_m);
  number("pebble_drift_m", summary.pebble_drift_m);
  number("energy_rise", summary.energy_rise);
  number("border_violation", summary.border_violation);
  writer.Key("wheel_steps");
  writer.StartObject();
  count("free", summary.wheel_steps_free);
  count("stick", summary.wheel_steps_stick);
  count("slip", summary.wheel_steps_slip);
  writer.EndObject();
  count("most_newton_steps", static_cast<std::uint64_t>(summary.most_newton_steps));
  count("most_convex_passes", static_cast<std::uint64_t>(summary.most_convex_passes));
  text("outcome", summary.outcome == Halt::none ? "ok" : rig::name_of(summary.outcome));
  if (summary.outcome != Halt::none) count("halting_wheel", summary.halting_wheel);
  if (!summary.reason.empty()) text("reason", summary.reason);
  if (summary.recurrence) {
    writer.Key("recurrence");
    writer.StartObject();
    count("seen_at_step", summary.recurrence->first);
    count("period", summary.recurrence->second);
    writer.EndObject();
  }
  writer.EndObject();
  return std::string(buffer.GetString()) + "\n";
}

}  // namespace groundtruth::report
