#pragma once
// What hostile implementations are made of: they read asks and answer every one with a miss, but for their
// one vice.

#include <unistd.h>

#include <functional>
#include <iostream>
#include <string>

namespace hostile {

inline void say(const std::string& text) { std::cout << text << std::flush; }

inline std::string miss(const std::string& id) {
  return R"({"id":)" + id +
         R"(,"answer":{"kind":"miss"}})"
         "\n";
}

inline std::string hello(const std::string& version, const std::string& name, const std::string& asks) {
  return R"({"hello":")" + version + R"(","name":")" + name + R"(","asks":[)" + asks + "]}\n";
}

inline const std::string good_hello = hello("answers/1", "hostile", R"("entry","clip","step")");

struct Ask {
  std::string id;          // as JSON
  int number = 1;          // of this process
  bool is_poison = false;  // the one that the vice waits for
};

// Calls `on_ask` for every ask, until the input ends.
inline void listen(const std::function<void(const Ask&)>& on_ask, const std::string& greeting = good_hello) {
  int number = 0;
  for (std::string line; std::getline(std::cin, line);) {
    if (line.find("\"hello\"") != std::string::npos) say(greeting);
    const std::string key = "{\"id\":";
    if (!line.starts_with(key)) continue;
    const std::string id = line.substr(key.size(), line.find(',') - key.size());
    on_ask({id, ++number, line.find("666") != std::string::npos});
  }
}

[[noreturn]] inline void sleep_for_ever() {
  while (true) pause();
}

}  // namespace hostile
