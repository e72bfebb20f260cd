#include <btBulletCollisionCommon.h>

#include <groundtruth/tests/bench/peer.hpp>
#include <groundtruth/tests/bench/polytope.hpp>

namespace groundtruth::bench {

namespace {

// A convex hull without margin for each cell, in a tree of boxes.
class Hulls {
 public:
  Hulls(const Scene& scene, double reach)
      : dispatcher_(&configuration_), world_(&dispatcher_, &broadphase_, &configuration_) {
    for (const Cell& cell : cells_of(scene)) {
      auto hull = std::make_unique<btConvexHullShape>();
      for (const Vector& corner : polytope_of(cell, reach).corners)
        hull->addPoint(btVector3(corner[0], corner[1], corner[2]), false);
      hull->setMargin(0);
      hull->recalcLocalAabb();
      auto object = std::make_unique<btCollisionObject>();
      object->setCollisionShape(hull.get());
      world_.addCollisionObject(object.get());
      hulls_.push_back(std::move(hull));
      objects_.push_back(std::move(object));
    }
    broadphase_.optimize();
  }
  ~Hulls() {
    for (const auto& object : objects_) world_.removeCollisionObject(object.get());
  }
  Hulls(const Hulls&) = delete;
  Hulls& operator=(const Hulls&) = delete;

  bool is_hit_by(const EntryAsk& ask) const {
    const btVector3 from(ask.from[0], ask.from[1], ask.from[2]), to(ask.to[0], ask.to[1], ask.to[2]);
    btCollisionWorld::ClosestRayResultCallback nearest(from, to);
    world_.rayTest(from, to, nearest);
    return nearest.hasHit();
  }

 private:
  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_;
  btDbvtBroadphase broadphase_;
  btCollisionWorld world_;
  std::vector<std::unique_ptr<btConvexHullShape>> hulls_;
  std::vector<std::unique_ptr<btCollisionObject>> objects_;
};

}  // namespace

Peer bullet(const Scene& scene, double reach) {
  const auto hulls = std::make_shared<Hulls>(scene, reach);
  return {"Bullet", [=](std::span<const EntryAsk> asks) {
            std::size_t hits = 0;
            for (const EntryAsk& ask : asks) hits += hulls->is_hit_by(ask);
            return hits;
          }};
}

}  // namespace groundtruth::bench
