#pragma once

#include <cstddef>
#include <new>
#include <span>
#include <type_traits>

#include "planner/base/contract.hpp"

namespace cnc::order {

/// Adds up the bytes of a working storage.
///
/// The working storage of an algorithm is a struct of spans with a member `lay_out(layout, sizes)`,
/// which calls `layout(span, count)` for each span. There are two layouts: StorageSize adds up the
/// bytes, and StorageParts cuts the spans out of a block of that size. The spans are not
/// initialized, so large storage costs nothing unless it is used.
class StorageSize {
 public:
  template <typename Item>
  void operator()(std::span<Item>&, std::size_t count) {
    static_assert(alignof(Item) <= kAlignment);
    bytes_ += (count * sizeof(Item) + kAlignment - 1) / kAlignment * kAlignment;
  }
  [[nodiscard]] std::size_t bytes() const { return bytes_; }

  static constexpr std::size_t kAlignment = alignof(double);

 private:
  std::size_t bytes_ = 0;
};

class StorageParts {
 public:
  /// @param block must be aligned like a double, and must outlive the spans
  explicit StorageParts(std::span<std::byte> block) : rest_{block} {}

  /// Cuts the span `part` with `count` items out of the block.
  /// @pre The block has at least as many bytes as StorageSize computes.
  template <typename Item>
  void operator()(std::span<Item>& part, std::size_t count) {
    StorageSize size;
    size(part, count);
    CNC_ASSERT(size.bytes() <= rest_.size());
    static_assert(std::is_trivial_v<Item>);
    auto* const first = reinterpret_cast<Item*>(rest_.data());
    for (std::size_t i = 0; i < count; ++i) new (first + i) Item;
    part = {first, count};
    rest_ = rest_.subspan(size.bytes());
  }

 private:
  std::span<std::byte> rest_;
};

/// Returns the number of bytes that the working storage `Space` requires.
template <typename Space, typename Sizes>
[[nodiscard]] std::size_t bytes_for(const Sizes& sizes) {
  StorageSize size;
  Space{}.lay_out(size, sizes);
  return size.bytes();
}

/// Returns a working storage in `block`, which has bytes_for<Space>(sizes) bytes.
template <typename Space, typename Sizes>
[[nodiscard]] Space space_in(std::span<std::byte> block, const Sizes& sizes) {
  StorageParts parts{block};
  Space space;
  space.lay_out(parts, sizes);
  return space;
}

}  // namespace cnc::order
