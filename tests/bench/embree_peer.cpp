#include <embree3/rtcore.h>

#include <limits>

#include <groundtruth/tests/bench/peer.hpp>
#include <groundtruth/tests/bench/polytope.hpp>

namespace groundtruth::bench {

namespace {

// Triangles in floats, in a scene of Embree's own making, built by one thread.
class Triangles {
 public:
  Triangles(const Scene& scene, double reach)
      : device_(rtcNewDevice("threads=1")), scene_(rtcNewScene(device_)) {
    Polytope all;
    for (const Cell& cell : cells_of(scene)) append(all, polytope_of(cell, reach));
    const RTCGeometry mesh = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* const corners = static_cast<float*>(
        rtcSetNewGeometryBuffer(mesh, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 12, all.corners.size()));
    auto* const places = static_cast<std::uint32_t*>(
        rtcSetNewGeometryBuffer(mesh, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 12, all.triangles.size()));
    for (std::size_t i = 0; i < all.corners.size(); ++i)
      for (std::size_t axis = 0; axis < 3; ++axis)
        corners[3 * i + axis] = static_cast<float>(all.corners[i][axis]);
    for (std::size_t i = 0; i < all.triangles.size(); ++i)
      for (std::size_t corner = 0; corner < 3; ++corner) places[3 * i + corner] = all.triangles[i][corner];
    rtcCommitGeometry(mesh);
    rtcAttachGeometry(scene_, mesh);
    rtcReleaseGeometry(mesh);
    rtcCommitScene(scene_);
  }
  Triangles(const Triangles&) = delete;
  Triangles& operator=(const Triangles&) = delete;
  ~Triangles() {
    rtcReleaseScene(scene_);
    rtcReleaseDevice(device_);
  }

  RTCScene scene() const { return scene_; }

 private:
  static void append(Polytope& all, const Polytope& one) {
    const auto first = static_cast<std::uint32_t>(all.corners.size());
    all.corners.insert(all.corners.end(), one.corners.begin(), one.corners.end());
    for (const auto& triangle : one.triangles)
      all.triangles.push_back({first + triangle[0], first + triangle[1], first + triangle[2]});
  }

  RTCDevice device_;
  RTCScene scene_;
};

std::size_t one_by_one(RTCScene scene, std::span<const EntryAsk> asks) {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  std::size_t hits = 0;
  for (const EntryAsk& ask : asks) {
    RTCRayHit at{};
    at.ray.org_x = static_cast<float>(ask.from[0]);
    at.ray.org_y = static_cast<float>(ask.from[1]);
    at.ray.org_z = static_cast<float>(ask.from[2]);
    at.ray.dir_x = static_cast<float>(ask.to[0] - ask.from[0]);
    at.ray.dir_y = static_cast<float>(ask.to[1] - ask.from[1]);
    at.ray.dir_z = static_cast<float>(ask.to[2] - ask.from[2]);
    at.ray.tfar = 1;
    at.ray.mask = 0xffffffff;
    at.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(scene, &context, &at);
    hits += at.hit.geomID != RTC_INVALID_GEOMETRY_ID;
  }
  return hits;
}

constexpr std::size_t packet = 16;

std::size_t in_packets(RTCScene scene, std::span<const EntryAsk> asks) {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  std::size_t hits = 0;
  for (std::size_t first = 0; first + packet <= asks.size(); first += packet) {
    alignas(64) RTCRayHit16 at{};
    alignas(64) int valid[packet];
    for (std::size_t i = 0; i < packet; ++i) {
      const EntryAsk& ask = asks[first + i];
      valid[i] = -1;
      at.ray.org_x[i] = static_cast<float>(ask.from[0]);
      at.ray.org_y[i] = static_cast<float>(ask.from[1]);
      at.ray.org_z[i] = static_cast<float>(ask.from[2]);
      at.ray.dir_x[i] = static_cast<float>(ask.to[0] - ask.from[0]);
      at.ray.dir_y[i] = static_cast<float>(ask.to[1] - ask.from[1]);
      at.ray.dir_z[i] = static_cast<float>(ask.to[2] - ask.from[2]);
      at.ray.tfar[i] = 1;
      at.ray.mask[i] = 0xffffffff;
      at.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
    }
    rtcIntersect16(valid, scene, &context, &at);
    for (const unsigned geometry : at.hit.geomID) hits += geometry != RTC_INVALID_GEOMETRY_ID;
  }
  return hits;
}

}  // namespace

Peer embree(const Scene& scene, double reach) {
  const auto triangles = std::make_shared<Triangles>(scene, reach);
  return {"Embree", [=](std::span<const EntryAsk> asks) { return one_by_one(triangles->scene(), asks); }};
}

Peer embree_packets(const Scene& scene, double reach) {
  const auto triangles = std::make_shared<Triangles>(scene, reach);
  return {"Embree 16", [=](std::span<const EntryAsk> asks) { return in_packets(triangles->scene(), asks); }};
}

}  // namespace groundtruth::bench
