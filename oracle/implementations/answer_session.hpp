#pragma once
// The answering side of the protocol of SPEC section 8: lines in, lines out.

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include <groundtruth/implementations/engine.hpp>

namespace groundtruth::implementations {

class AnswerSession {
 public:
  // `place` names the text in messages; scene files are sought relative to `folder`.
  AnswerSession(const Engine& engine, std::string place, std::filesystem::path folder);

  // The line that answers the next line of the text, both without line end; absent if none is due. Never
  // throws on what the line says.
  std::optional<std::string> answer(std::string_view line);

 private:
  class Respond;

  void use(Scene scene);
  Answered answer_without_scene(const Ask& ask) const;

  const Engine& engine_;
  std::string place_;
  std::filesystem::path folder_;
  std::size_t line_number_ = 0;
  bool asked_ = false;
  std::optional<Scene> scene_;
  std::unique_ptr<const EngineOnScene> engine_on_scene_;
};

}  // namespace groundtruth::implementations
