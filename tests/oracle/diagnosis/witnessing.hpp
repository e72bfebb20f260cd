#pragma once
// Implementations asked, judged and diagnosed.

#include <deque>
#include <string>
#include <vector>

#include <groundtruth/diagnosis/diagnose.hpp>
#include <groundtruth/implementations/engine.hpp>
#include <groundtruth/judge/verdict.hpp>

namespace groundtruth::diagnosis {

struct Judged {
  std::vector<Witness> failures, accepted;
};

// Asks that are spread over scenes, kinds and differences, with their exact answers.
class Asking {
 public:
  // The corpus, ends of ranges beyond 2^63, and `asks_a_scene` generated asks about each small scene built
  // in.
  explicit Asking(std::size_t asks_a_scene);

  // Judged by the exact profile.
  Judged judge(const implementations::Engine& subject) const;

 private:
  struct Asked {
    cases::Case asked;
    Answer exact;
  };
  struct OfScene {
    OfScene(const Scene& of, std::vector<cases::Case> asks);
    Scene scene;
    judge::Judge judge;
    std::vector<Asked> asked;
  };
  std::deque<OfScene> scenes_;
};

// "name", "name = equal", or "-".
std::string told(const std::optional<Diagnosis>& diagnosis);

// Is this one of the names that the diagnosis gives?
bool names(const std::optional<Diagnosis>& diagnosis, const std::string& name);

}  // namespace groundtruth::diagnosis
