#include <groundtruth/diagnosis/suspects.hpp>

#include <array>
#include <memory>

#include <groundtruth/diagnosis/slips.hpp>
#include <groundtruth/implementations/engine.hpp>

namespace groundtruth::diagnosis {
namespace {

struct NamedErratum {
  std::string_view name;
  std::string_view explanation;
};

// SPEC section 7, as far as they are switches of the as-written engine.
constexpr std::array<NamedErratum, 11> switches{{
    {"single-pass-intersection", "an intersection is gone through once"},
    {"normal-by-order", "the first operand to reach lambda gives the normal"},
    {"miss-is-plus-1000", "a miss is the end of the range + 1000"},
    {"surface-frame-sign", "the surface frame is turned the other way"},
    {"band-test-wheel-x", "the brake band is tested with the wheel's F_x, not the surface's"},
    {"signed-normal-force", "the disc's radius has the normal force's sign"},
    {"force-on-frame-sign", "the frame gets the force that acts on the pebble"},
    {"no-liftoff", "a wheel above its pebble keeps sticking"},
    {"tensile-contact", "the ground may pull"},
    {"spring-relocation", "return mapping is taken for the spring relocation"},
    {"frame-rotation-ignored", "the frame's angular velocity is left out"},
}};

Suspect suspect_of_engine(const std::string& name, const std::string& explanation,
                          const std::string& engine_name) {
  std::shared_ptr<const implementations::Engine> engine = implementations::make_engine(engine_name);
  return {name, explanation,
          [engine](const Scene& scene, const Ask& ask) { return engine->on(scene)->answer(ask).answer; },
          Trace::own_error};
}

Answer exactly(const Scene& scene, const Ask& ask) {
  static const auto engine = implementations::make_engine("exact");
  return engine->on(scene)->answer(ask).answer;
}

}  // namespace

std::vector<Suspect> errata() {
  std::vector<Suspect> suspects;
  for (const auto& [name, explanation] : switches)
    suspects.push_back(
        suspect_of_engine(std::string(name), std::string(explanation), "as-written:" + std::string(name)));
  return suspects;
}

std::vector<Suspect> pairs_of_errata() {
  std::vector<Suspect> suspects;
  for (std::size_t a = 0; a < switches.size(); ++a) {
    for (std::size_t b = a + 1; b < switches.size(); ++b) {
      const std::string first(switches[a].name), second(switches[b].name);
      suspects.push_back(suspect_of_engine(
          first + " and " + second,
          std::string(switches[a].explanation) + "; " + std::string(switches[b].explanation),
          "as-written:" + first + "," + second));
    }
  }
  return suspects;
}

std::vector<Suspect> classic_slips() {
  std::vector<Suspect> suspects;
  suspects.push_back(
      suspect_of_engine("plain-doubles", "the arithmetic is right but for rounding", "double"));
  suspects.back().trace = Trace::rounding;
  for (const AskSlip& slip : ask_slips())
    suspects.push_back({std::string(slip.name), std::string(slip.explanation),
                        [change = slip.change](Scene scene, Ask ask) {
                          change(scene, ask);
                          return exactly(scene, ask);
                        },
                        Trace::own_error});
  for (const AnswerSlip& slip : answer_slips())
    suspects.push_back({std::string(slip.name), std::string(slip.explanation),
                        [change = slip.change](const Scene& scene, const Ask& ask) {
                          Answer answer = exactly(scene, ask);
                          change(answer, ask);
                          return answer;
                        },
                        Trace::own_error});
  return suspects;
}

}  // namespace groundtruth::diagnosis
