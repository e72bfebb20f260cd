#include <groundtruth/as_written/clip.hpp>
#include <groundtruth/as_written/entry_point.hpp>
#include <groundtruth/as_written/errata.hpp>
#include <groundtruth/as_written/step.hpp>
#include <groundtruth/implementations/adapters.hpp>
#include <groundtruth/implementations/errata.hpp>

namespace groundtruth::implementations {
namespace {

using as_written::Errata;

class AsWrittenOnScene : public EngineOnScene {
 public:
  AsWrittenOnScene(const Scene& scene, const Errata& errata) : scene_(scene), errata_(errata) {}

  Answered answer(const Ask& ask) const override {
    return {std::visit([this](const auto& kind) { return ask_as_written(kind); }, ask), {}};
  }

 private:
  Answer ask_as_written(const EntryAsk& ask) const { return as_written::entry_point(scene_, ask, errata_); }
  Answer ask_as_written(const ClipAsk& ask) const { return as_written::clip(ask, errata_); }
  Answer ask_as_written(const StepAsk& ask) const { return as_written::step(scene_, ask, errata_); }

  as_written::Scene scene_;
  Errata errata_;
};

class AsWrittenEngine : public Engine {
 public:
  AsWrittenEngine(std::string name, const Errata& errata) : name_(std::move(name)), errata_(errata) {}
  std::string name() const override { return name_; }
  std::unique_ptr<const EngineOnScene> on(const Scene& scene) const override {
    return std::make_unique<AsWrittenOnScene>(scene, errata_);
  }

 private:
  std::string name_;
  Errata errata_;
};

}  // namespace

std::unique_ptr<const Engine> make_double_engine() {
  return std::make_unique<AsWrittenEngine>("double", Errata{});
}

std::unique_ptr<const Engine> make_as_written_engine(std::string_view names) {
  if (names.empty()) return std::make_unique<AsWrittenEngine>("as-written", as_written::all_errata());
  Errata errata;
  std::string_view rest = names;
  for (bool more = true; more;) {
    const auto comma = rest.find(',');
    const auto erratum = as_written::erratum_named(rest.substr(0, comma));
    if (!erratum) return nullptr;
    errata.add(*erratum);
    more = comma != std::string_view::npos;
    if (more) rest.remove_prefix(comma + 1);
  }
  return std::make_unique<AsWrittenEngine>("as-written:" + std::string(names), errata);
}

std::vector<std::string> erratum_names() {
  std::vector<std::string> names;
  for (const as_written::Erratum erratum : as_written::errata_in_order())
    names.emplace_back(as_written::name_of(erratum));
  return names;
}

}  // namespace groundtruth::implementations
