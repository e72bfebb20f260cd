#pragma once
// Vectors that may be very large.

#include <cstddef>
#include <memory>
#include <vector>

namespace groundtruth::fast {

// Memory that is asked for in large pages where the system has them: a page touched for the first time costs
// the same, small or large, and of a large scene's small ones there are ten thousands.
inline constexpr std::size_t large_page = std::size_t{1} << 21;
void* allocate_large_pages(std::size_t bytes);  // throws std::bad_alloc
void free_large_pages(void* memory);

template <class Element>
struct LargePages {
  using value_type = Element;

  LargePages() = default;
  template <class Other>
  LargePages(const LargePages<Other>&) {}

  Element* allocate(std::size_t count) {
    if (!is_large(count)) return std::allocator<Element>().allocate(count);
    return static_cast<Element*>(allocate_large_pages(count * sizeof(Element)));
  }
  void deallocate(Element* memory, std::size_t count) {
    if (is_large(count))
      free_large_pages(memory);
    else
      std::allocator<Element>().deallocate(memory, count);
  }
  template <class Other>
  bool operator==(const LargePages<Other>&) const {
    return true;
  }

 private:
  static bool is_large(std::size_t count) { return count >= 2 * large_page / sizeof(Element); }
};

template <class Element>
using LargeVector = std::vector<Element, LargePages<Element>>;

}  // namespace groundtruth::fast
