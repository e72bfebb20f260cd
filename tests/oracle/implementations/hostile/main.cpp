// hostile VICE TOKEN: an implementation with one vice. TOKEN marks its processes, so that tests find those
// that are left.

#include <fcntl.h>
#include <poll.h>

#include <chrono>
#include <csignal>
#include <map>
#include <optional>
#include <thread>
#include <utility>

#include "program.hpp"

namespace hostile {
namespace {

using Vice = std::function<void()>;

void answer(const Ask& ask) { say(miss(ask.id)); }

// Answers all asks but the poisonous one.
Vice at_poison(const std::function<void(const Ask&)>& act) {
  return [act] { listen([act](const Ask& ask) { ask.is_poison ? act(ask) : answer(ask); }); };
}

Vice at_every_ask(const std::function<void(const Ask&)>& act) {
  return [act] { listen(act); };
}

Vice greets_with(const std::string& greeting) {
  return [greeting] { listen(answer, greeting); };
}

// `text` has %, where the id goes.
Vice answers_with(const std::string& before, const std::string& after) {
  return at_poison([=](const Ask& ask) { say(before + ask.id + after + "\n"); });
}

void segfault(const Ask&) { std::raise(SIGSEGV); }

bool more_is_waiting() {
  pollfd input{STDIN_FILENO, POLLIN, 0};
  return std::cin.rdbuf()->in_avail() > 0 || poll(&input, 1, 0) > 0;
}

void swap_pairs() {
  std::optional<Ask> kept;
  listen([&](const Ask& ask) {
    if (!kept) {
      kept = ask;
      return;
    }
    answer(ask);
    answer(*kept);
    kept.reset();
  });
}

// Its session, its parent and its group tell nothing of where it comes from.
void leave_daemon() {
  if (fork() != 0) return;
  setsid();
  for (const int number : {SIGTERM, SIGHUP, SIGINT, SIGPIPE}) std::signal(number, SIG_IGN);
  if (fork() != 0) _exit(0);
  sleep_for_ever();
}

void ignore_the_end() {
  std::signal(SIGTERM, SIG_IGN);
  listen(answer);
  sleep_for_ever();
}

void flood(int file, std::size_t bytes, const std::string& block) {
  for (std::size_t written = 0; written < bytes;) {
    const ssize_t count = write(file, block.data(), block.size());
    if (count < 0) _exit(1);
    written += static_cast<std::size_t>(count);
  }
}

constexpr std::size_t without_end = ~std::size_t{0};
constexpr std::size_t megabyte = 1'000'000;
const std::string zeros(65536, '0');

std::string as_utf16(const std::string& text) {
  std::string wide;
  for (const char character : text) wide += std::string{'\0', character};
  return wide;
}

void drip(const std::string& text) {
  for (const char character : text) {
    say({character});
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
}

const std::map<std::string, Vice> vices = {
    {"none", at_every_ask(answer)},
    {"exits-at-once", [] { _exit(3); }},
    {"crashes-at-once", [] { std::raise(SIGSEGV); }},
    {"crashes-at-poison", at_poison(segfault)},
    {"crashes-at-third", at_every_ask([](const Ask& ask) { ask.number == 3 ? segfault(ask) : answer(ask); })},
    {"crashes-in-batches",
     at_every_ask([](const Ask& ask) { more_is_waiting() ? segfault(ask) : answer(ask); })},
    {"crashes-in-mid-line", at_poison([](const Ask& ask) { say(miss(ask.id).substr(0, 9)), segfault(ask); })},
    {"hangs-at-once", sleep_for_ever},
    {"hangs-at-poison", at_poison([](const Ask&) { sleep_for_ever(); })},
    {"hangs-with-answers-kept",
     [] {
       std::string kept;
       listen([&](const Ask& ask) {
         if (ask.is_poison) sleep_for_ever();
         kept += miss(ask.id);
         if (!more_is_waiting()) say(std::exchange(kept, {}));
       });
     }},
    {"hangs-in-batches",
     at_every_ask([](const Ask& ask) { more_is_waiting() ? sleep_for_ever() : answer(ask); })},
    {"stops-at-poison", at_poison([](const Ask&) { std::raise(SIGSTOP); })},
    {"answers-late", at_poison([](const Ask& ask) {
       std::this_thread::sleep_for(std::chrono::milliseconds(900));
       answer(ask);
     })},
    {"never-flushes",
     [] {
       std::string answers;
       listen([&](const Ask& ask) { answers += miss(ask.id); });
       say(answers);
     }},
    {"floods-output", at_poison([](const Ask&) { flood(STDOUT_FILENO, without_end, zeros); })},
    {"floods-lines", at_poison([](const Ask&) { flood(STDOUT_FILENO, without_end, good_hello); })},
    {"floods-errors", at_every_ask([](const Ask& ask) {
       flood(STDERR_FILENO, 4 * megabyte, zeros);
       answer(ask);
     })},
    {"says-garbage", at_poison([](const Ask&) { say("I think it misses\n"); })},
    {"says-garbage-too", at_poison([](const Ask& ask) { say("let me see\n"), answer(ask); })},
    {"says-utf16", at_poison([](const Ask& ask) { say(as_utf16(miss(ask.id))); })},
    {"says-binary", at_poison([](const Ask&) { say(std::string("\xff\0\xfe\x80\x01\n", 6)); })},
    {"says-nan", answers_with("{\"id\":", R"(,"answer":{"kind":"inside","lambda":NaN}})")},
    {"says-1e999", answers_with("{\"id\":", R"(,"answer":{"kind":"inside","lambda":1e999}})")},
    {"repeats-keys", answers_with("{\"id\":", R"(,"answer":{"kind":"miss","kind":"miss"}})")},
    {"nests-deeply", answers_with("{\"id\":", ",\"answer\":" + std::string(megabyte, '['))},
    {"names-no-leaf", answers_with("{\"id\":", R"(,"answer":{"kind":"border","lambda":0,"leaf":-1}})")},
    {"gives-other-id", answers_with(R"({"id":"b1","was":)", R"(,"answer":{"kind":"miss"}})")},
    {"refuses", answers_with("{\"id\":", R"(,"error":"too hard for me"})")},
    {"swaps-answers", swap_pairs},
    {"skips-poison", at_poison([](const Ask&) {})},
    {"answers-twice", at_poison([](const Ask& ask) { say(miss(ask.id) + miss(ask.id)); })},
    {"answers-too-many", at_poison([](const Ask& ask) { say(miss(ask.id) + miss("\"c1\"")); })},
    {"stops-after-two", at_every_ask([](const Ask& ask) {
       answer(ask);
       if (ask.number == 2) _exit(0);
     })},
    {"answers-before",
     [] {
       say(miss("\"a1\"") + miss("\"a2\""));
       listen(answer);
     }},
    {"closes-output", at_poison([](const Ask&) { close(STDOUT_FILENO), sleep_for_ever(); })},
    {"closes-input",
     [] {
       listen([](const Ask& ask) {
         answer(ask);
         if (ask.is_poison) close(STDIN_FILENO), sleep_for_ever();
       });
     }},
    {"ignores-the-end", ignore_the_end},
    {"drips", at_every_ask([](const Ask& ask) { drip(miss(ask.id)); })},
    {"claims-unknown-kinds", greets_with(hello("answers/1", "liar", R"("entry","warp",7)"))},
    {"claims-other-version", greets_with(hello("answers/9", "liar", R"("entry")"))},
    {"has-huge-name", greets_with(hello("answers/1", std::string(megabyte, 'x'), R"("entry")"))},
    {"greets-strangely", greets_with("{\"hello\":\"answers/1\",\"name\":[],\"asks\":{}}\n")},
    {"knows-no-hello", greets_with("{\"id\":null,\"error\":\"what is a hello?\"}\n")},
    {"prints-a-banner", greets_with("Welcome!\n" + good_hello)},
    {"dies-of-hello",
     [] {
       std::string line;
       std::getline(std::cin, line);
       if (line.find("hello") == std::string::npos) listen(answer);
       std::abort();
     }},
    {"leaves-daemons", at_every_ask([](const Ask& ask) { leave_daemon(), answer(ask); })},
    {"leaves-daemon-and-crashes", at_poison([](const Ask& ask) { leave_daemon(), segfault(ask); })},
    {"kills-its-parent", at_poison([](const Ask&) { kill(getppid(), SIGKILL), sleep_for_ever(); })},
};

}  // namespace
}  // namespace hostile

int main(int count, char** arguments) {
  const auto vice = hostile::vices.find(count > 1 ? arguments[1] : "none");
  if (vice == hostile::vices.end()) return 99;
  std::ios::sync_with_stdio(false);
  vice->second();
}
