#include <groundtruth/text/answer_text.hpp>

#include <groundtruth/text/json_writer.hpp>
#include <groundtruth/text/state_writer.hpp>

namespace groundtruth {
namespace {

void write_enclosures(JsonWriter& writer, const std::vector<Enclosure>& enclosures) {
  if (enclosures.empty()) return;
  writer.key("enclosures");
  writer.open_object();
  for (const auto& [quantity, lower, upper] : enclosures) {
    writer.key(quantity);
    writer.open_array();
    writer.text(lower);
    writer.text(upper);
    writer.close_array();
  }
  writer.close_object();
}

class AnswerWriter {
 public:
  AnswerWriter(JsonWriter& writer, const Evidence& evidence, const Scene& scene)
      : writer_(writer), evidence_(evidence), scene_(scene) {}

  void operator()(const EntryAnswer& answer) { visit(answer); }
  void operator()(const ClipAnswer& answer) { visit(answer); }
  void operator()(const StepAnswer& answer) { visit(answer); }

  void operator()(const Refusal& refusal) { writer_.member("error", refusal.reason); }
  void operator()(const Miss&) {
    write([&] { writer_.member("kind", "miss"); });
  }
  void operator()(const Inside& inside) {
    write([&] {
      writer_.member("kind", "inside");
      write_lambda(inside.lambda);
    });
  }
  void operator()(const Border& border) {
    write([&] {
      writer_.member("kind", "border");
      write_lambda(border.lambda);
      writer_.key("leaf");
      writer_.count(border.leaf);
      writer_.member("normal", border.normal_in_world);
      writer_.key("material");
      border.material ? writer_.text(scene_.materials[*border.material].name) : writer_.null();
      write_admissible();
    });
  }
  void operator()(const TooSteep&) {
    write([&] { writer_.member("kind", "too_steep"); });
  }
  void operator()(const Clipped& clipped) {
    write([&] {
      writer_.member("kind", clipped.grip == Grip::stick ? "stick" : "slip");
      writer_.member("force", clipped.force_in_wheel);
    });
  }
  void operator()(const Stepped& stepped) {
    write([&] {
      writer_.member("outcome", "ok");
      writer_.key("state");
      write_state(writer_, stepped.state);
      writer_.member("force", stepped.force_on_frame_in_world);
    });
  }
  void operator()(StepFailure failure) {
    constexpr std::array<const char*, 3> names = {"wheel_broken", "surface_too_steep", "surface_gave_way"};
    write([&] { writer_.member("outcome", names[static_cast<std::size_t>(failure)]); });
  }

 private:
  template <typename Alternatives>
  void visit(const Alternatives& answer) {
    std::visit([this](const auto& alternative) { (*this)(alternative); }, answer);
  }

  template <typename Members>
  void write(const Members& write_members) {
    writer_.key("answer");
    writer_.open_object();
    write_members();
    write_enclosures(writer_, evidence_.enclosures);
    writer_.close_object();
  }

  void write_lambda(double lambda) {
    writer_.member("lambda", lambda);
    if (!evidence_.lambda_exact.empty()) writer_.member("lambda_exact", evidence_.lambda_exact);
  }

  void write_admissible() {
    if (evidence_.admissible.empty()) return;
    writer_.key("admissible");
    writer_.open_array();
    for (const Leaf leaf : evidence_.admissible) writer_.count(leaf);
    writer_.close_array();
  }

  JsonWriter& writer_;
  const Evidence& evidence_;
  const Scene& scene_;
};

}  // namespace

std::string write_answer(const std::string& id, const Answer& answer, const Evidence& evidence,
                         const Scene& scene) {
  JsonWriter writer;
  writer.open_object();
  writer.key("id");
  writer.json(id);
  std::visit(AnswerWriter(writer, evidence, scene), answer);
  writer.close_object();
  return writer.take();
}

std::string write_error(const std::string& id, const std::string& problem) {
  JsonWriter writer;
  writer.open_object();
  writer.key("id");
  writer.json(id);
  writer.member("error", problem);
  writer.close_object();
  return writer.take();
}

std::string write_hello(const std::string& name) {
  JsonWriter writer;
  writer.open_object();
  writer.member("hello", "answers/1");
  writer.member("name", name);
  writer.key("asks");
  writer.open_array();
  for (const char* kind : {"entry", "clip", "step"}) writer.text(kind);
  writer.close_array();
  writer.close_object();
  return writer.take();
}

}  // namespace groundtruth
