#include <groundtruth/fast/large_vector.hpp>

#include <cstdlib>
#include <new>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace groundtruth::fast {

void* allocate_large_pages(std::size_t bytes) {
  const std::size_t whole_pages = (bytes + large_page - 1) / large_page * large_page;
  void* const memory = std::aligned_alloc(large_page, whole_pages);
  if (memory == nullptr) throw std::bad_alloc();
#ifdef __linux__
  madvise(memory, whole_pages, MADV_HUGEPAGE);  // a wish: small pages do as well
#endif
  return memory;
}

void free_large_pages(void* memory) { std::free(memory); }

}  // namespace groundtruth::fast
