#include "ways.hpp"

namespace groundtruth::planted {

Prepare reads(Scene (*misread)(Scene)) {
  return [misread](const Scene& scene) -> Answering {
    return [right = std::make_shared<const Right>(misread(scene))](const Ask& ask) {
      return right->answer(ask);
    };
  };
}

Prepare on_borders(EntryAnswer (*spoil)(const Meeting&)) {
  return [spoil](const Scene& scene) -> Answering {
    return [spoil, right = std::make_shared<const Right>(scene)](const Ask& ask) -> Answer {
      const Answer answer = right->answer(ask);
      const auto* asked = std::get_if<EntryAsk>(&ask);
      if (asked == nullptr) return answer;
      const auto* border = std::get_if<Border>(&std::get<EntryAnswer>(answer));
      return border ? Answer{spoil(Meeting(*right, *asked, *border))} : answer;
    };
  };
}

Prepare on_lambdas(double (*spoil)(double, const EntryAsk&)) {
  return [spoil](const Scene& scene) -> Answering {
    return [spoil, right = std::make_shared<const Right>(scene)](const Ask& ask) -> Answer {
      Answer answer = right->answer(ask);
      const auto* asked = std::get_if<EntryAsk>(&ask);
      if (asked == nullptr) return answer;
      auto& entry = std::get<EntryAnswer>(answer);
      if (auto* border = std::get_if<Border>(&entry)) border->lambda = spoil(border->lambda, *asked);
      if (auto* inside = std::get_if<Inside>(&entry)) inside->lambda = spoil(inside->lambda, *asked);
      return answer;
    };
  };
}

}  // namespace groundtruth::planted
