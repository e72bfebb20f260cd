#include <groundtruth/implementations/child.hpp>

#include <fcntl.h>
#include <poll.h>
#include <sys/wait.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <system_error>

namespace groundtruth::implementations {
namespace {

struct Pipe {
  Descriptor reading;
  Descriptor writing;
};

Pipe make_pipe() {
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) throw std::system_error(errno, std::generic_category(), "no more pipes");
  return {Descriptor(ends[0]), Descriptor(ends[1])};
}

Descriptor unblocked(Descriptor end) {
  fcntl(end.number(), F_SETFL, fcntl(end.number(), F_GETFL) | O_NONBLOCK);
  return end;
}

}  // namespace

Child::Child(const Entry& entry) {
  Pipe to_input = make_pipe();
  Pipe from_output = make_pipe();
  Pipe from_errors = make_pipe();
  Pipe from_status = make_pipe();
  Pipe life = make_pipe();
  keeper_ = fork();
  if (keeper_ < 0) throw std::system_error(errno, std::generic_category(), "no more processes");
  if (keeper_ == 0) {
    keep({to_input.reading.number(), from_output.writing.number(), from_errors.writing.number(),
          from_status.writing.number(), life.reading.number()},
         entry);
  }
  input = unblocked(std::move(to_input.writing));
  output = unblocked(std::move(from_output.reading));
  errors = unblocked(std::move(from_errors.reading));
  status = unblocked(std::move(from_status.reading));
  lifeline_ = std::move(life.writing);
}

Child::~Child() {
  constexpr std::chrono::milliseconds grace(500);
  input.close();
  output.close();
  errors.close();
  ending(grace);
  kill();
}

const std::optional<Ending>& Child::ending(std::chrono::milliseconds wait) {
  if (ending_ || !status.is_open()) return ending_;
  pollfd news{status.number(), POLLIN, 0};
  if (poll(&news, 1, static_cast<int>(wait.count())) <= 0) return ending_;
  Ending sent;
  const bool is_whole = read(status.number(), &sent, sizeof sent) == sizeof sent;
  // Nothing sent: the keeper itself was killed, and its child with it.
  ending_ = is_whole ? sent : Ending{Ending::How::killed_by_signal, SIGKILL, {}};
  return ending_;
}

void Child::kill() {
  if (keeper_ < 0) return;
  lifeline_.close();
  while (waitpid(keeper_, nullptr, 0) < 0 && errno == EINTR) continue;
  keeper_ = -1;
}

std::string describe(const Ending& ending) {
  const std::string number = std::to_string(ending.number);
  switch (ending.how) {
    case Ending::How::not_started:
      return std::string("it cannot be started: ") + ending.problem;
    case Ending::How::exited:
      return "exited with code " + number;
    case Ending::How::killed_by_signal:
      return "ended by signal " + number + " (" + strsignal(ending.number) + ")";
  }
  return {};
}

}  // namespace groundtruth::implementations
