#pragma once
// What the exact engine says of a scene, and of the scenes around it that a tolerance allows. Private to this
// folder.

#include <map>
#include <memory>
#include <mutex>

#include <groundtruth/implementations/engine.hpp>
#include <groundtruth/judge/verdict.hpp>

#include "leaves.hpp"

namespace groundtruth::judge {

using implementations::Answered;

// Each further scene is prepared when it is first asked about. Several threads may ask at once.
class Truth {
 public:
  Truth(const Scene& scene, const Tolerance& tolerance);

  const Scene& scene() const { return scene_; }
  const Tolerance& tolerance() const { return tolerance_; }
  const std::vector<HalfSpace>& leaves() const { return leaves_; }

  Answered answer(const Ask& ask) const { return exact_->answer(ask); }
  // Of the shape with every plane moved outwards, or inwards, by the tolerance.
  Answered answer_on_grown(const Ask& ask) const;
  Answered answer_on_shrunk(const Ask& ask) const;
  // Of the same solid with this leaf as number 0: the contact is this leaf's if it is admissible at all.
  Answered answer_with_leaf_first(Leaf leaf, const Ask& ask) const;
  // Of the same solid, all of a material that every tyre of this name holds on.
  Answered answer_on_plain_ground(const std::string& tyre, const Ask& ask) const;

 private:
  using Prepared = std::unique_ptr<const implementations::EngineOnScene>;

  template <typename Key, typename MakeScene>
  const implementations::EngineOnScene& prepared(std::map<Key, Prepared>& of, const Key& key,
                                                 const MakeScene& make_scene) const;

  Scene scene_;
  Tolerance tolerance_;
  std::vector<HalfSpace> leaves_;
  std::unique_ptr<const implementations::Engine> engine_;
  Prepared exact_;
  mutable std::mutex mutex_;
  mutable std::map<double, Prepared> with_planes_moved_;  // by metres
  mutable std::map<Leaf, Prepared> with_leaf_first_;
  mutable std::map<std::string, Prepared> on_plain_ground_;  // by tyre
};

}  // namespace groundtruth::judge
