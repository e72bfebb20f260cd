// A user of the fast engine alone: no CGAL, no GMP, no JSON.
#include <cstdio>

#include <groundtruth/fast/entry_point.hpp>

int main() {
  using namespace groundtruth;
  const Scene ground{{}, {HalfSpace{{0, 0, 1}, 0}}};
  const EntryAnswer answer = fast::entry_point(fast::compile(ground), {{0, 0, 1}, {0, 0, -3}});
  std::printf("fast %a\n", std::get<Border>(answer).lambda);
}
