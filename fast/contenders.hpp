#pragma once
// The parts that a range may meet first, as far as a search has come. Not installed.
//
// Kernels fill it: what they call is inlined always (cell_kernels_body.hpp).

#include <cstdint>
#include <memory>

#include <groundtruth/fast/meeting.hpp>
#include <groundtruth/fast/parts.hpp>

namespace groundtruth::fast {

struct Contender {
  Part part = 0;
  Meeting meeting;
};

// A list that allocates only for more than 128.
class Contenders {
 public:
  Contenders() {}
  Contenders(const Contenders&) = delete;
  Contenders& operator=(const Contenders&) = delete;

  [[gnu::always_inline]] inline void push_back(const Contender& contender) {
    if (size_ == capacity_) grow();
    first_[size_++] = contender;
  }
  [[gnu::always_inline]] inline bool has(Part part) const {
    for (const Contender* at = first_; at != first_ + size_; ++at)
      if (at->part == part) return true;
    return false;
  }

  // Keeps the first ones.
  void shrink(std::size_t size) { size_ = size; }
  bool empty() const { return size_ == 0; }
  std::size_t size() const { return size_; }
  Contender* data() { return first_; }
  Contender* begin() { return first_; }
  Contender* end() { return first_ + size_; }
  const Contender* begin() const { return first_; }
  const Contender* end() const { return first_ + size_; }
  const Contender& front() const { return *first_; }
  Contender& operator[](std::size_t place) { return first_[place]; }

 private:
  static constexpr std::size_t few = 128;

  void grow();

  union {
    Contender own_[few];  // not written before they are wanted
  };
  Contender* first_ = own_;
  std::size_t size_ = 0, capacity_ = few;
  std::unique_ptr<Contender[]> more_;
};

}  // namespace groundtruth::fast
