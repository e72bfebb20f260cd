#include <groundtruth/tests/bench/peer.hpp>

namespace groundtruth::bench {

Peer embree(const Scene&, double) { return {"Embree", {}}; }
Peer embree_packets(const Scene&, double) { return {"Embree 16", {}}; }

}  // namespace groundtruth::bench
