#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>

#include "planner/base/contract.hpp"

namespace cnc {

/// A queue of bytes. The bytes that were added since the last settle() are not settled and can be
/// removed again. Used in one context only. The three counts wrap.
class TextQueue {
 public:
  /// @param storage memory of the queue; outlives this object; its size is a power of two, so that
  ///     the remainder is computed with a mask
  explicit TextQueue(std::span<std::byte> storage) : bytes_{storage} {
    CNC_ASSERT(std::has_single_bit(storage.size()));
  }

  [[nodiscard]] std::uint32_t capacity() const { return static_cast<std::uint32_t>(bytes_.size()); }
  /// Returns the number of bytes that can be added.
  [[nodiscard]] std::uint32_t room() const { return capacity() - (added_ - taken_); }
  /// Returns the number of settled bytes in the queue.
  [[nodiscard]] std::uint32_t settled() const { return settled_ - taken_; }

  /// Adds bytes at the end of the queue.
  /// @pre bytes.size() is at most room()
  void add(std::span<const std::byte> bytes) {
    for (const std::byte byte : bytes) place(added_++) = byte;
  }
  void settle() { settled_ = added_; }
  /// Removes all bytes that are not settled.
  void take_back() { added_ = settled_; }

  /// Returns the settled byte at index `n`; index 0 is the oldest byte.
  /// @pre n < settled()
  [[nodiscard]] std::byte at(std::uint32_t n) const { return place(taken_ + n); }
  /// Removes the oldest `count` bytes.
  /// @pre count is at most settled()
  void drop(std::uint32_t count) { taken_ += count; }

  void clear() { taken_ = settled_ = added_; }

 private:
  [[nodiscard]] std::byte& place(std::uint32_t count) const {
    return bytes_[count & (capacity() - 1)];
  }

  std::span<std::byte> bytes_;
  std::uint32_t added_ = 0;
  std::uint32_t settled_ = 0;
  std::uint32_t taken_ = 0;
};

}  // namespace cnc
