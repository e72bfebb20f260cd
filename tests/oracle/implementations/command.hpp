#pragma once
// Programs under test, and what is left of them.

#include <chrono>
#include <memory>
#include <string>
#include <vector>

#include <groundtruth/implementations/subject.hpp>

namespace groundtruth::implementations::test {

constexpr Patience short_patience{std::chrono::milliseconds(800), std::chrono::milliseconds(2000)};

// hostile VICE TOKEN; the token is this process's and tells its processes from others'.
std::vector<std::string> hostile(const std::string& vice);

// Fails the test and ends it if there is none.
std::unique_ptr<Subject> subject(SubjectOrNone found);

// Every ask misses the ground but for one below it, which the hostile take for poison.
Scene ground();
std::vector<Ask> asks(std::size_t count, std::size_t poison);

// A letter a reply: answered, refused, unreadable, crashed, hung.
std::string kinds(const std::vector<Reply>& replies);

// Running processes whose command line has our token.
std::vector<std::string> processes_left();

std::size_t open_descriptors();

}  // namespace groundtruth::implementations::test
