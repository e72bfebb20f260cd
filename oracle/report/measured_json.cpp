#include <groundtruth/report/measured_files.hpp>

#include <fstream>
#include <sstream>
#include <stdexcept>

#include <groundtruth/report/stability_names.hpp>
#include <groundtruth/text/json.hpp>
#include <groundtruth/text/json_writer.hpp>

namespace groundtruth::report {
namespace {

using precision::TierResult;

constexpr const char* form = "report/1";

std::string name_of_study(const Study& study) {
  return study.scene + "/" + std::string(precision::name_of(study.kind)) + "/" +
         std::string(precision::name_of(study.population));
}

void write(JsonWriter& json, const char* name, const precision::Spread& spread) {
  json.member(name, std::array<double, 3>{spread.least, spread.median, spread.most});
}

void write(JsonWriter& json, const char* name, const std::optional<precision::Witness>& witness) {
  json.key(name);
  if (!witness) return json.null();
  json.open_object();
  json.key("part"), json.count(witness->part);
  json.key("index"), json.count(witness->index);
  json.key("ask"), json.json(witness->ask);
  json.close_object();
}

void write(JsonWriter& json, const TierResult& result) {
  json.open_object();
  json.member("tier", result.tier);
  json.member("description", result.description);
  if (!result.omitted.empty()) {
    json.member("omitted", result.omitted);
    return json.close_object();
  }
  json.key("asks"), json.count(result.asks);
  json.key("wrong"), json.count(result.wrong);
  json.key("undecided"), json.count(result.undecided);
  json.key("with_number"), json.count(result.with_number);
  json.member("median_ulps", result.median_ulps);
  json.member("worst_ulps", result.worst_ulps);
  write(json, "ns", result.nanoseconds);
  json.key("timed_asks"), json.count(result.timed_asks);
  json.member("on_front", result.is_on_front ? "yes" : "no");
  write(json, "worst", result.worst);
  write(json, "first_wrong", result.first_wrong);
  json.close_object();
}

void write(JsonWriter& json, const Study& study) {
  json.open_object();
  json.member("study", name_of_study(study));
  json.key("leaves"), json.count(study.leaves);
  json.key("asks"), json.count(study.asks);
  json.key("tiers");
  json.open_array();
  for (const TierResult& result : study.results) write(json, result);
  json.close_array();
  json.close_object();
}

void write(JsonWriter& json, const precision::LeftOutWorth& worth) {
  json.open_object();
  json.member("scene", worth.scene);
  json.member("what", worth.what);
  json.key("count"), json.count(worth.count);
  json.key("asks"), json.count(worth.asks);
  write(json, "with_ns", worth.with_ns);
  write(json, "without_ns", worth.without_ns);
  json.member("same_answers", worth.same_answers ? "yes" : "no");
  json.close_object();
}

void write(JsonWriter& json, const precision::TrajectoryRun& run) {
  json.open_object();
  json.member("motion", run.motion);
  json.member("stiffness", run.stiffness);
  json.member("integrator", rig::name_of(run.integrator));
  json.member("relocation", name_of(run.relocation));
  json.member("h", run.h);
  json.member("error_m", run.error_m);
  json.member("seconds", run.seconds);
  json.member("mark", precision::name_of(run.mark));
  json.close_object();
}

void write(JsonWriter& json, const Omission& omission) {
  json.open_object();
  json.member("what", omission.what);
  json.member("why", omission.why);
  json.close_object();
}

template <class Items>
void write_all(JsonWriter& json, const char* name, const Items& items) {
  json.key(name);
  json.open_array();
  for (const auto& item : items) write(json, item);
  json.close_array();
}

const Json* member_of(const Json& json, const std::string& name) {
  const auto* object = std::get_if<Json::Object>(&json.value);
  if (object == nullptr) return nullptr;
  for (const auto& [key, value] : *object)
    if (key == name) return &value;
  return nullptr;
}

// Reads what json_of() wrote, and says which field is not as it should be.
class Reader {
 public:
  explicit Reader(std::string file) : file_(std::move(file)) {}

  template <class Wanted>
  const Wanted& get(const Json& json, const std::string& name) const {
    const Json* found = member_of(json, name);
    const Wanted* value = found ? std::get_if<Wanted>(&found->value) : nullptr;
    if (value == nullptr)
      throw BadInput(file_, found ? found->line : json.line, name, "is missing or of another type");
    return *value;
  }
  std::size_t count(const Json& json, const std::string& name) const {
    return static_cast<std::size_t>(get<double>(json, name));
  }
  double median(const Json& json, const std::string& name) const {
    const auto& spread = get<Json::Array>(json, name);
    const double* value = spread.size() == 3 ? std::get_if<double>(&spread[1].value) : nullptr;
    if (value == nullptr) throw BadInput(file_, json.line, name, "is not [least, median, most]");
    return *value;
  }

 private:
  std::string file_;
};

std::string text_of(const std::string& file) {
  std::ifstream stream(file, std::ios::binary);
  std::stringstream text;
  text << stream.rdbuf();
  if (!stream) throw std::runtime_error(file + ": cannot be read");
  return text.str();
}

}  // namespace

std::string json_of(const Measured& measured) {
  JsonWriter json;
  json.open_object();
  json.member("groundtruth", form);
  json.member("processor", measured.machine.processor);
  json.member("compiler", measured.machine.compiler);
  json.member("flags", measured.machine.flags);
  json.member("commit", measured.machine.commit);
  json.member("extent", measured.extent);
  json.key("seed"), json.count(measured.seed);
  json.member("seconds", measured.seconds);
  write_all(json, "studies", measured.studies);
  write_all(json, "left_out", measured.left_out);
  write_all(json, "trajectories", measured.trajectories);
  write_all(json, "omissions", measured.omissions);
  json.close_object();
  return json.take() + "\n";
}

std::vector<precision::TierFigure> tier_figures_of(const Measured& measured) {
  std::vector<precision::TierFigure> figures;
  for (const Study& study : measured.studies)
    for (const TierResult& result : study.results)
      if (result.omitted.empty())
        figures.push_back({name_of_study(study), result.tier, result.asks, result.wrong + result.undecided,
                           result.worst_ulps, result.nanoseconds.median});
  return figures;
}

std::vector<precision::TierFigure> read_tier_figures(const std::string& file) {
  const Json json = parse_json(text_of(file), {file});
  const Reader reader(file);
  if (reader.get<std::string>(json, "groundtruth") != form)
    throw BadInput(file, json.line, "groundtruth", std::string("is not \"") + form + "\"");
  std::vector<precision::TierFigure> figures;
  for (const Json& study : reader.get<Json::Array>(json, "studies"))
    for (const Json& tier : reader.get<Json::Array>(study, "tiers")) {
      if (member_of(tier, "omitted")) continue;
      figures.push_back({reader.get<std::string>(study, "study"), reader.get<std::string>(tier, "tier"),
                         reader.count(tier, "asks"),
                         reader.count(tier, "wrong") + reader.count(tier, "undecided"),
                         reader.get<double>(tier, "worst_ulps"), reader.median(tier, "ns")});
    }
  return figures;
}

}  // namespace groundtruth::report
