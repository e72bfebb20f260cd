#include <groundtruth/report/check_report.hpp>

#include <algorithm>

#include <fmt/format.h>
#include <rapidjson/stringbuffer.h>
#include <rapidjson/writer.h>

namespace groundtruth::report {
namespace {

using campaign::Tally;
using judge::Difference;

constexpr Difference counted[] = {Difference::hit_miss, Difference::lambda,     Difference::face,
                                  Difference::material, Difference::stick_slip, Difference::state,
                                  Difference::numbers,  Difference::refusal};

double nanoseconds_of_double(const CheckedScene& checked) {
  const auto found = std::find(checked.engines.begin(), checked.engines.end(), "double");
  if (found == checked.engines.end()) return 0;
  return checked.tallies[static_cast<std::size_t>(found - checked.engines.begin())].nanoseconds_per_ask();
}

std::string ratio(double nanoseconds, double of_double) {
  return of_double > 0 ? fmt::format("{:.2f}", nanoseconds / of_double) : "-";
}

std::string ulps(double value) { return value == 0 ? "0" : fmt::format("{:.3g}", value); }

std::string place_of(const CheckedScene& checked, const campaign::Place& place) {
  return fmt::format("{}:{}:{}", checked.name, place.part, place.index);
}

}  // namespace

std::string table_of(const CheckedScene& checked) {
  std::string text =
      fmt::format("{} ({} leaves)\n  {:<12}{:>8}", checked.name, checked.leaves, "engine", "asks");
  for (const Difference difference : counted) text += fmt::format("{:>11}", judge::name_of(difference));
  text += fmt::format("{:>12}{:>12}{:>11}{:>9}\n", "lambda ulps", "force ulps", "ns/ask", "x double");
  const double of_double = nanoseconds_of_double(checked);
  for (std::size_t i = 0; i < checked.engines.size(); ++i) {
    const Tally& tally = checked.tallies[i];
    text += fmt::format("  {:<12}{:>8}", checked.engines[i], tally.asks());
    for (const Difference difference : counted) text += fmt::format("{:>11}", tally.count(difference));
    text += fmt::format("{:>12}{:>12}{:>11.0f}{:>9}\n", ulps(tally.worst_lambda().ulps),
                        ulps(tally.worst_vector().ulps), tally.nanoseconds_per_ask(),
                        ratio(tally.nanoseconds_per_ask(), of_double));
  }
  for (std::size_t i = 0; i < checked.engines.size(); ++i) {
    const Tally& tally = checked.tallies[i];
    if (tally.left_out() == 0) continue;
    text += fmt::format("  {}: {} asks of its kinds were not put to it, as it is slow\n", checked.engines[i],
                        tally.left_out());
  }
  return text;
}

std::string json_of(const CheckedScene& checked) {
  std::string lines;
  for (std::size_t i = 0; i < checked.engines.size(); ++i) {
    const Tally& tally = checked.tallies[i];
    rapidjson::StringBuffer buffer;
    rapidjson::Writer<rapidjson::StringBuffer> writer(buffer);
    const auto member = [&](const char* key, const auto& write) {
      writer.Key(key);
      write();
    };
    const auto worst = [&](const campaign::Worst& of) {
      writer.StartObject();
      member("ulps", [&] { writer.Double(of.ulps); });
      member("ask", [&] { writer.String(place_of(checked, of.place).c_str()); });
      writer.EndObject();
    };
    writer.StartObject();
    member("scene", [&] { writer.String(checked.name.c_str()); });
    member("leaves", [&] { writer.Uint64(checked.leaves); });
    member("engine", [&] { writer.String(checked.engines[i].c_str()); });
    member("asks", [&] { writer.Uint64(tally.asks()); });
    member("left_out", [&] { writer.Uint64(tally.left_out()); });
    writer.Key("disagreements");
    writer.StartObject();
    for (const Difference difference : counted) {
      member(std::string(judge::name_of(difference)).c_str(),
             [&] { writer.Uint64(tally.count(difference)); });
    }
    writer.EndObject();
    member("worst_lambda", [&] { worst(tally.worst_lambda()); });
    member("worst_force", [&] { worst(tally.worst_vector()); });
    member("ns_per_ask", [&] { writer.Double(tally.nanoseconds_per_ask()); });
    writer.EndObject();
    lines += std::string(buffer.GetString()) + "\n";
  }
  return lines;
}

std::string findings_of(const CheckedScene& checked, std::size_t engine, const std::string& show_command) {
  const Tally& tally = checked.tallies[engine];
  std::string text;
  const auto line = [&](const std::string& what, const campaign::Place& place) {
    text += fmt::format("  {} {}: {} {}\n", checked.engines[engine], what, show_command,
                        place_of(checked, place));
  };
  if (tally.worst_lambda().ulps > 0) {
    line("worst lambda, " + ulps(tally.worst_lambda().ulps) + " ulps", tally.worst_lambda().place);
  }
  if (tally.worst_vector().ulps > 0) {
    line("worst force, " + ulps(tally.worst_vector().ulps) + " ulps", tally.worst_vector().place);
  }
  for (const campaign::Disagreement& example : tally.examples()) {
    if (example.difference == Difference::lambda || example.difference == Difference::numbers) continue;
    line(fmt::format("differs in {}", judge::name_of(example.difference)), example.place);
  }
  return text;
}

}  // namespace groundtruth::report
