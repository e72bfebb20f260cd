#pragma once
// Cases to be put to an implementation, a batch about one scene at a time.

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <groundtruth/problem/ask.hpp>
#include <groundtruth/problem/scene.hpp>
#include <groundtruth/validation/finding.hpp>

namespace groundtruth::validation {

struct Batch {
  std::shared_ptr<const Scene> scene;
  std::vector<std::string> ids;
  std::vector<Ask> asks;
};

class Stream {
 public:
  virtual ~Stream() = default;
  // Absent: there are no more.
  virtual std::optional<Batch> next() = 0;
  // What came of the last batch, one an ask: a stream may choose the next by it.
  virtual void learn(std::span<const Finding> findings) = 0;
  // It ended before its cases did, as so many had failed.
  virtual bool has_failed_enough() const { return false; }
};

// Told of a case, by its id, and what came of it.
using Listen = std::function<void(const std::string&, const Finding&)>;

// Given cases, in their order; neighbours with one scene make a batch.
std::unique_ptr<Stream> stream_of(
    std::vector<cases::Case> given, Listen listen = [](const std::string&, const Finding&) {});

}  // namespace groundtruth::validation
