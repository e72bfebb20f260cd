#include "right.hpp"

namespace groundtruth::planted {

Right::Right(Scene scene)
    : scene_(std::move(scene)),
      leaves_(leaves_of(scene_.shape)),
      fast_engine_(implementations::make_engine("fast")),
      exact_engine_(implementations::make_engine("exact")),
      fast_(fast_engine_->on(scene_)),
      exact_(exact_engine_->on(scene_)) {}

}  // namespace groundtruth::planted
