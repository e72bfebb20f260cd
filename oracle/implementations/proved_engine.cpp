#include <filesystem>
#include <mutex>
#include <stdexcept>

#include <groundtruth/implementations/adapters.hpp>
#include <groundtruth/implementations/subject.hpp>

namespace groundtruth::implementations {
namespace {

constexpr const char* program_name = "proved-phi";

// Beside this program, as it is built and installed, or on PATH.
std::string program() {
  std::error_code ignored;
  const auto here = std::filesystem::read_symlink("/proc/self/exe", ignored).parent_path() / program_name;
  return std::filesystem::exists(here, ignored) ? here.string() : program_name;
}

std::unique_ptr<Subject> start() {
  auto started = run_command({program()}, {std::chrono::minutes(10), std::chrono::seconds(30)});
  if (auto* subject = std::get_if<std::unique_ptr<Subject>>(&started)) return std::move(*subject);
  return nullptr;
}

// A process for each thread that asks at the same time.
class ProvedOnScene : public EngineOnScene {
 public:
  explicit ProvedOnScene(const Scene& scene) : scene_(scene) {}

  Answered answer(const Ask& ask) const override {
    std::unique_ptr<Subject> subject = take();
    Reply reply = subject->ask(scene_, {&ask, 1}).front();
    if (reply.kind != ReplyKind::answered) throw std::runtime_error(program_name + (": " + reply.detail));
    const std::lock_guard lock(mutex_);
    idle_.push_back(std::move(subject));
    return {std::move(reply.answer), std::move(reply.evidence)};
  }

 private:
  std::unique_ptr<Subject> take() const {
    {
      const std::lock_guard lock(mutex_);
      if (!idle_.empty()) {
        std::unique_ptr<Subject> subject = std::move(idle_.back());
        idle_.pop_back();
        return subject;
      }
    }
    std::unique_ptr<Subject> subject = start();
    if (subject == nullptr) throw std::runtime_error(std::string(program_name) + " does not start any more");
    return subject;
  }

  Scene scene_;
  mutable std::mutex mutex_;
  mutable std::vector<std::unique_ptr<Subject>> idle_;
};

class ProvedEngine : public Engine {
 public:
  std::string name() const override { return "proved"; }
  std::unique_ptr<const EngineOnScene> on(const Scene& scene) const override {
    return std::make_unique<ProvedOnScene>(scene);
  }
};

}  // namespace

std::unique_ptr<const Engine> make_proved_engine() {
  if (start() == nullptr) return nullptr;
  return std::make_unique<ProvedEngine>();
}

}  // namespace groundtruth::implementations
