#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>

#include <groundtruth/implementations/piped_subject.hpp>

namespace groundtruth::implementations {
namespace {

std::string execute(const std::vector<std::string>& command) {
  std::vector<char*> arguments;
  for (const std::string& argument : command) arguments.push_back(const_cast<char*>(argument.c_str()));
  arguments.push_back(nullptr);
  execvp(arguments.front(), arguments.data());
  return command.front() + ": " + std::strerror(errno);
}

}  // namespace

SubjectOrNone run_command(const std::vector<std::string>& command, const Patience& patience) {
  if (command.empty()) return NoSubject{"no command is given"};
  return piped_subject([command] { return execute(command); }, patience);
}

}  // namespace groundtruth::implementations
