#pragma once
// An implementation in a process of its own, its standard streams in our hands. Private to this folder.

#include <sys/types.h>

#include <chrono>
#include <optional>
#include <string>

#include <groundtruth/implementations/descriptor.hpp>
#include <groundtruth/implementations/keeper.hpp>

namespace groundtruth::implementations {

class Child {
 public:
  // Throws std::system_error if pipes or processes run out.
  explicit Child(const Entry& entry);
  // Ends its input and gives it a grace to leave; then kills it with everything it started.
  ~Child();

  // Ours never block.
  Descriptor input;   // what it reads
  Descriptor output;  // what it writes
  Descriptor errors;
  Descriptor status;

  // How it ended, once that is known; waits for the news for so long.
  const std::optional<Ending>& ending(std::chrono::milliseconds wait);
  // Kills it with everything it started. What it wrote before can still be read.
  void kill();

 private:
  Descriptor lifeline_;
  pid_t keeper_ = -1;
  std::optional<Ending> ending_;
};

// "ended by signal 11 (Segmentation fault)", "exited with code 3".
std::string describe(const Ending& ending);

}  // namespace groundtruth::implementations
