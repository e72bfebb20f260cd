#include <groundtruth/implementations/keeper.hpp>

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>

namespace groundtruth::implementations {
namespace {

constexpr int lifeline_in_keeper = 4;

// Moves the ends to 0..4 by way of higher numbers, as they may stand in each other's place.
void arrange(const KeeperEnds& ends) {
  std::array<int, 5> places = {ends.input, ends.output, ends.errors, ends.status, ends.lifeline};
  constexpr int beyond = 16;
  for (int& place : places) place = fcntl(place, F_DUPFD_CLOEXEC, beyond);
  for (int i = 0; i < 5; ++i) dup2(places[static_cast<std::size_t>(i)], i);
  close_range(5, ~0U, 0);
  fcntl(status_in_child, F_SETFD, FD_CLOEXEC);
  fcntl(lifeline_in_keeper, F_SETFD, FD_CLOEXEC);
}

void ignore_news(int) {}

void send(const Ending& ending) {
  // It fits into any pipe at once, and whoever has closed the other end does not want it.
  [[maybe_unused]] const ssize_t sent = write(status_in_child, &ending, sizeof ending);
}

[[noreturn]] void become(const Entry& entry) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  setsid();
  close(lifeline_in_keeper);
  for (int number = 1; number < NSIG; ++number) signal(number, SIG_DFL);
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
  const rlimit no_dump{0, 0};
  setrlimit(RLIMIT_CORE, &no_dump);
  const std::string problem = entry();
  Ending ending{Ending::How::not_started, 0, {}};
  std::strncpy(ending.problem, problem.c_str(), sizeof ending.problem - 1);
  send(ending);
  _exit(127);
}

void kill_children() {
  const int file = open("/proc/thread-self/children", O_RDONLY | O_CLOEXEC);
  std::array<char, 4096> text;
  const ssize_t size = file < 0 ? 0 : read(file, text.data(), text.size());
  if (file >= 0) close(file);
  pid_t child = 0;
  for (ssize_t i = 0; i < size; ++i) {
    const char character = text[static_cast<std::size_t>(i)];
    if (character >= '0' && character <= '9') {
      child = 10 * child + (character - '0');
    } else if (child > 0) {
      kill(child, SIGKILL);
      child = 0;
    }
  }
}

// Whoever loses its parent here becomes a child of this process, so the children run out only with the last
// descendant.
void kill_all(pid_t group) {
  kill(-group, SIGKILL);
  while (true) {
    kill_children();
    pid_t reaped = 0;
    do {
      reaped = waitpid(-1, nullptr, WNOHANG);
    } while (reaped > 0);
    if (reaped < 0 && errno == ECHILD) return;
    constexpr int a_moment = 1;  // ms
    poll(nullptr, 0, a_moment);
  }
}

// Returns how the child ended, or that it was still running when the lifeline did.
Ending wait_for_end(pid_t child, const sigset_t& awake) {
  while (true) {
    int status = 0;
    for (pid_t reaped = waitpid(-1, &status, WNOHANG); reaped > 0; reaped = waitpid(-1, &status, WNOHANG)) {
      if (reaped != child) continue;
      if (WIFEXITED(status)) return {Ending::How::exited, WEXITSTATUS(status), {}};
      return {Ending::How::killed_by_signal, WTERMSIG(status), {}};
    }
    pollfd lifeline{lifeline_in_keeper, POLLIN, 0};
    if (ppoll(&lifeline, 1, nullptr, &awake) > 0) return {Ending::How::killed_by_signal, SIGKILL, {}};
  }
}

}  // namespace

void keep(const KeeperEnds& ends, const Entry& entry) {
  arrange(ends);
  setsid();  // so that an interrupt from the terminal ends us, and through the lifeline everything
  prctl(PR_SET_CHILD_SUBREAPER, 1, 0, 0, 0);
  sigset_t awake;
  sigset_t all;
  sigfillset(&all);
  sigprocmask(SIG_SETMASK, &all, nullptr);
  sigfillset(&awake);
  sigdelset(&awake, SIGCHLD);
  struct sigaction on_news = {};
  on_news.sa_handler = ignore_news;
  sigaction(SIGCHLD, &on_news, nullptr);

  const pid_t child = fork();
  if (child == 0) become(entry);
  for (const int end : {0, 1, 2}) close(end);
  if (child < 0) {
    send({Ending::How::not_started, 0, "no process could be forked"});
    _exit(0);
  }
  const Ending ending = wait_for_end(child, awake);
  kill_all(child);
  send(ending);
  _exit(0);
}

}  // namespace groundtruth::implementations
