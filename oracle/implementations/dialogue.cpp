#include <groundtruth/implementations/dialogue.hpp>

#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>

namespace groundtruth::implementations {
namespace {

constexpr std::size_t chunk = std::size_t{1} << 16;

bool may_come_later() { return errno == EAGAIN || errno == EINTR; }

int milliseconds_until(Clock::time_point until) {
  const auto left = std::chrono::ceil<std::chrono::milliseconds>(until - Clock::now());
  return static_cast<int>(std::clamp<std::chrono::milliseconds::rep>(left.count(), 0, 60000));
}

// Writing to a program that reads no more raises a signal, which is not to end this process.
class WithoutSigpipe {
 public:
  WithoutSigpipe() {
    sigemptyset(&sigpipe_);
    sigaddset(&sigpipe_, SIGPIPE);
    sigset_t pending;
    sigpending(&pending);
    was_pending_ = sigismember(&pending, SIGPIPE) == 1;
    pthread_sigmask(SIG_BLOCK, &sigpipe_, &before_);
  }
  ~WithoutSigpipe() {
    const timespec at_once{0, 0};
    if (!was_pending_) sigtimedwait(&sigpipe_, nullptr, &at_once);
    pthread_sigmask(SIG_SETMASK, &before_, nullptr);
  }
  WithoutSigpipe(const WithoutSigpipe&) = delete;
  WithoutSigpipe& operator=(const WithoutSigpipe&) = delete;

 private:
  sigset_t sigpipe_;
  sigset_t before_;
  bool was_pending_;
};

}  // namespace

void Tail::add(std::string_view bytes) {
  constexpr std::size_t enough = std::size_t{1} << 12;
  text_ += bytes;
  if (text_.size() > enough) text_.erase(0, text_.size() - enough);
}

void Dialogue::say(std::string_view line) {
  outbox_.erase(0, sent_);
  sent_ = 0;
  outbox_ += line;
  outbox_ += '\n';
}

void Dialogue::send() {
  const WithoutSigpipe guard;
  const ssize_t count = write(child_.input.number(), outbox_.data() + sent_, unsent());
  if (count >= 0) {
    sent_ += static_cast<std::size_t>(count);
  } else if (!may_come_later()) {
    child_.input.close();  // it reads no more; that is no fault until an answer is missing
  }
}

void Dialogue::receive_output() {
  std::array<char, chunk> bytes;
  const ssize_t count = read(child_.output.number(), bytes.data(), bytes.size());
  if (count > 0) {
    lines_.add({bytes.data(), static_cast<std::size_t>(count)});
    received_ += static_cast<std::size_t>(count);
  } else if (count == 0 || !may_come_later()) {
    child_.output.close();
  }
}

void Dialogue::receive_errors() {
  std::array<char, chunk> bytes;
  const ssize_t count = read(child_.errors.number(), bytes.data(), bytes.size());
  if (count > 0) {
    words_.add({bytes.data(), static_cast<std::size_t>(count)});
  } else if (count == 0 || !may_come_later()) {
    child_.errors.close();
  }
}

void Dialogue::exchange(Clock::time_point until) {
  // Of a descriptor that is closed, poll() takes no notice.
  const int input = unsent() > 0 ? child_.input.number() : -1;
  std::array<pollfd, 3> streams = {pollfd{input, POLLOUT, 0}, pollfd{child_.output.number(), POLLIN, 0},
                                   pollfd{child_.errors.number(), POLLIN, 0}};
  if (poll(streams.data(), streams.size(), milliseconds_until(until)) <= 0) return;
  if (streams[0].revents != 0) send();
  if (streams[1].revents != 0) receive_output();
  if (streams[2].revents != 0) receive_errors();
}

std::string Dialogue::how_it_ended() {
  constexpr std::chrono::milliseconds last_moments(500);
  const auto& ending = child_.ending(last_moments);
  while (child_.errors.is_open() && ending) receive_errors();
  return ending ? describe(*ending) : "closed its standard output and ran on";
}

std::optional<std::string> Dialogue::why_not_started() {
  const auto& ending = child_.ending(std::chrono::milliseconds(0));
  if (!ending || ending->how != Ending::How::not_started) return std::nullopt;
  return ending->problem;
}

}  // namespace groundtruth::implementations
