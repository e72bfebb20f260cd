#pragma once
// Ways to make a mistake.

#include "bug.hpp"
#include "meeting.hpp"

namespace groundtruth::planted {

// The scene is read wrongly. The misread one has as many leaves and the same materials.
Prepare reads(Scene (*misread)(Scene));

// One kind of ask is answered by `wrong`, the others rightly.
template <class OneAsk, class OneAnswer>
Prepare answers(OneAnswer (*wrong)(const OneAsk&, const Right&)) {
  return [wrong](const Scene& scene) -> Answering {
    return [wrong, right = std::make_shared<const Right>(scene)](const Ask& ask) -> Answer {
      if (const auto* asked = std::get_if<OneAsk>(&ask)) return wrong(*asked, *right);
      return right->answer(ask);
    };
  };
}

// One kind of ask is understood wrongly.
template <class OneAsk>
Prepare understands(OneAsk (*misunderstood)(OneAsk)) {
  return [misunderstood](const Scene& scene) -> Answering {
    return [misunderstood, right = std::make_shared<const Right>(scene)](const Ask& ask) {
      const auto* asked = std::get_if<OneAsk>(&ask);
      return right->answer(asked ? Ask{misunderstood(*asked)} : ask);
    };
  };
}

// Entry asks: an answer on a border is spoilt.
Prepare on_borders(EntryAnswer (*spoil)(const Meeting&));

// Entry asks: lambda is spoilt wherever there is one.
Prepare on_lambdas(double (*spoil)(double lambda, const EntryAsk&));

}  // namespace groundtruth::planted
