#include <groundtruth/implementations/engine.hpp>
#include <groundtruth/implementations/subject.hpp>

namespace groundtruth::implementations {
namespace {

std::optional<Refusal> refusal_in(const Answer& answer) {
  if (const auto* clip = std::get_if<ClipAnswer>(&answer)) {
    if (const auto* refusal = std::get_if<Refusal>(clip)) return *refusal;
  }
  if (const auto* step = std::get_if<StepAnswer>(&answer)) {
    if (const auto* refusal = std::get_if<Refusal>(step)) return *refusal;
  }
  return std::nullopt;
}

Reply reply_of(Answered answered) {
  Reply reply;
  if (const auto refusal = refusal_in(answered.answer)) {
    reply.kind = ReplyKind::refused;
    reply.detail = refusal->reason;
  }
  reply.answer = std::move(answered.answer);
  reply.evidence = std::move(answered.evidence);
  return reply;
}

class EngineSubject : public Subject {
 public:
  explicit EngineSubject(std::unique_ptr<const Engine> engine)
      : engine_(std::move(engine)), greeting_{"groundtruth " + engine_->name()} {}

  const Greeting& greeting() const override { return greeting_; }
  std::vector<Reply> ask(const Scene& scene, std::span<const Ask> asks) override {
    const auto on_scene = engine_->on(scene);
    std::vector<Reply> replies;
    replies.reserve(asks.size());
    for (const Ask& ask : asks) replies.push_back(reply_of(on_scene->answer(ask)));
    return replies;
  }
  std::string last_words() const override { return {}; }

 private:
  std::unique_ptr<const Engine> engine_;
  Greeting greeting_;
};

}  // namespace

SubjectOrNone engine_subject(const std::string& name) {
  auto engine = make_engine(name);
  if (engine == nullptr) return NoSubject{"no engine is called " + name};
  return std::make_unique<EngineSubject>(std::move(engine));
}

}  // namespace groundtruth::implementations
