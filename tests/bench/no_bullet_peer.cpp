#include <groundtruth/tests/bench/peer.hpp>

namespace groundtruth::bench {

Peer bullet(const Scene&, double) { return {"Bullet", {}}; }

}  // namespace groundtruth::bench
