#include <groundtruth/implementations/answer_session.hpp>

#include <groundtruth/text/answer_text.hpp>
#include <groundtruth/text/ask_text.hpp>
#include <groundtruth/text/scene_text.hpp>

namespace groundtruth::implementations {
namespace {

constexpr const char* no_scene = "no scene: the ask needs one, and none has been read";

}  // namespace

AnswerSession::AnswerSession(const Engine& engine, std::string place, std::filesystem::path folder)
    : engine_(engine), place_(std::move(place)), folder_(std::move(folder)) {}

class AnswerSession::Respond {
 public:
  explicit Respond(AnswerSession& session) : session_(session) {}

  std::optional<std::string> operator()(const HelloLine&) const {
    if (session_.asked_) return write_error("null", session_.place_ + ": hello comes before the first ask");
    return write_hello("groundtruth " + session_.engine_.name());
  }
  std::optional<std::string> operator()(SceneLine& line) const {
    session_.use(std::move(line.scene));
    return std::nullopt;
  }
  std::optional<std::string> operator()(const SceneFileLine& line) const {
    try {
      session_.use(read_scene_file((session_.folder_ / line.file).string()));
      return std::nullopt;
    } catch (const BadInput& bad) {
      return (*this)(BadSceneLine{bad.what()});
    }
  }
  std::optional<std::string> operator()(const BadSceneLine& line) const {
    session_.scene_.reset();
    session_.engine_on_scene_.reset();
    return write_error("null", line.problem);
  }
  std::optional<std::string> operator()(const BadLine& line) const {
    return write_error(line.id, line.problem);
  }
  std::optional<std::string> operator()(const AskLine& line) const {
    session_.asked_ = true;
    if (!session_.scene_) {
      const Answered answered = session_.answer_without_scene(line.ask);
      return write_answer(line.id, answered.answer, answered.evidence, Scene{});
    }
    const Answered answered = session_.engine_on_scene_->answer(line.ask);
    return write_answer(line.id, answered.answer, answered.evidence, *session_.scene_);
  }

 private:
  AnswerSession& session_;
};

void AnswerSession::use(Scene scene) {
  scene_ = std::move(scene);
  engine_on_scene_ = engine_.on(*scene_);
}

// A clip, or a step that does not slip, never looks at the scene: then it answers the same on nothing and on
// everything. One that does look misses on the first and starts inside on the second.
Answered AnswerSession::answer_without_scene(const Ask& ask) const {
  Answered on_nothing = engine_.on(Scene{{}, {Nothing{}}})->answer(ask);
  const Answered on_everything = engine_.on(Scene{{}, {Everything{}}})->answer(ask);
  if (on_nothing.answer == on_everything.answer) return on_nothing;
  return {StepAnswer{Refusal{no_scene}}, {}};
}

std::optional<std::string> AnswerSession::answer(std::string_view text) {
  ++line_number_;
  Line line = read_line(text, {place_, line_number_});
  return std::visit(Respond(*this), line);
}

}  // namespace groundtruth::implementations
