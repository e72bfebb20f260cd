#include <groundtruth/implementations/piped_subject.hpp>

#include <groundtruth/implementations/round.hpp>

namespace groundtruth::implementations {
namespace {

class PipedSubject : public Subject {
 public:
  PipedSubject(Entry entry, const Patience& patience) : connection_(std::move(entry), patience) {}

  std::optional<std::string> greet() { return connection_.greet(); }

  const Greeting& greeting() const override { return connection_.greeting(); }
  std::vector<Reply> ask(const Scene& scene, std::span<const Ask> asks) override {
    return Round(connection_, record_, scene, asks).run();
  }
  std::string last_words() const override { return connection_.last_words(); }

 private:
  Connection connection_;
  Record record_;
};

}  // namespace

SubjectOrNone piped_subject(Entry entry, const Patience& patience) {
  auto subject = std::make_unique<PipedSubject>(std::move(entry), patience);
  if (const auto why = subject->greet()) return NoSubject{*why};
  return subject;
}

}  // namespace groundtruth::implementations
