#include "truth.hpp"

#include "moved_planes.hpp"

namespace groundtruth::judge {

Truth::Truth(const Scene& scene, const Tolerance& tolerance)
    : scene_(scene),
      tolerance_(tolerance),
      leaves_(leaves_of(scene.shape)),
      engine_(implementations::make_engine("exact")),
      exact_(engine_->on(scene_)) {}

template <typename Key, typename MakeScene>
const implementations::EngineOnScene& Truth::prepared(std::map<Key, Prepared>& of, const Key& key,
                                                      const MakeScene& make_scene) const {
  const std::lock_guard lock(mutex_);
  Prepared& engine = of[key];
  if (engine == nullptr) engine = engine_->on(make_scene());
  return *engine;
}

Answered Truth::answer_on_grown(const Ask& ask) const {
  const double metres = tolerance_.metres;
  return prepared(with_planes_moved_, metres,
                  [&] {
                    return Scene{scene_.materials, with_planes_moved(scene_.shape, metres)};
                  })
      .answer(ask);
}

Answered Truth::answer_on_shrunk(const Ask& ask) const {
  const double metres = -tolerance_.metres;
  return prepared(with_planes_moved_, metres,
                  [&] {
                    return Scene{scene_.materials, with_planes_moved(scene_.shape, metres)};
                  })
      .answer(ask);
}

Answered Truth::answer_with_leaf_first(Leaf leaf, const Ask& ask) const {
  return prepared(with_leaf_first_, leaf,
                  [&] {
                    return Scene{scene_.materials, with_leaf_first(scene_.shape, leaf)};
                  })
      .answer(ask);
}

Answered Truth::answer_on_plain_ground(const std::string& tyre, const Ask& ask) const {
  return prepared(on_plain_ground_, tyre,
                  [&] {
                    return Scene{{{"plain", {{tyre, {}}}, {}}},
                                 {Covered{0, std::make_shared<const Shape>(scene_.shape)}}};
                  })
      .answer(ask);
}

}  // namespace groundtruth::judge
