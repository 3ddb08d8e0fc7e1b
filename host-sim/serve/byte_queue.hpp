#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>

namespace sim {

/// A bounded queue of bytes (first in, first out). Bytes that do not fit stay with the writer.
template <std::size_t Capacity>
class ByteQueue {
 public:
  [[nodiscard]] std::size_t room() const { return Capacity - size_; }
  [[nodiscard]] bool empty() const { return size_ == 0; }
  void clear() { first_ = size_ = 0; }

  /// Appends the bytes that fit, and returns their number.
  std::size_t push(std::span<const std::byte> from) {
    const std::size_t count = std::min(from.size(), room());
    for (std::size_t index = 0; index < count; ++index) {
      bytes_[(first_ + size_ + index) % Capacity] = from[index];
    }
    size_ += count;
    return count;
  }

  /// Returns the oldest bytes that are contiguous in memory; empty only if the queue is empty.
  [[nodiscard]] std::span<const std::byte> front() const {
    return {bytes_.data() + first_, std::min(size_, Capacity - first_)};
  }

  /// @pre count is at most front().size()
  void pop(std::size_t count) {
    first_ = (first_ + count) % Capacity;
    size_ -= count;
  }

 private:
  std::array<std::byte, Capacity> bytes_{};
  std::size_t first_ = 0;
  std::size_t size_ = 0;
};

}  // namespace sim
