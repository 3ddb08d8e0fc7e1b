#pragma once

#include <cstddef>
#include <deque>
#include <span>
#include <string>
#include <vector>

namespace sim {

/// A queue of bytes (first in, first out) of any length, in blocks. Growing does not move any
/// bytes, so that a thread with time limits can queue megabytes.
///
/// Some blocks are kept ready, with all their memory pages already touched. Without this, the
/// system would have to provide each page of 4 KiB during a read, which is slow, above all on
/// virtual machines.
class ByteBlocks {
 public:
  static constexpr std::size_t kBlock = std::size_t{1} << 20;
  /// Number of blocks of 1 MiB that are kept ready. They hold twice the 4 MiB that the operating
  /// system of a sender may buffer.
  static constexpr std::size_t kReady = 8;

  /// @throw std::bad_alloc
  ByteBlocks();

  [[nodiscard]] std::size_t size() const { return size_; }

  /// @throw std::bad_alloc
  void append(std::span<const char> bytes);
  /// Returns the oldest bytes that are contiguous in memory; empty only if the queue is empty.
  [[nodiscard]] std::span<const char> front() const;
  /// @pre count is at most front().size()
  void pop(std::size_t count);
  void clear();
  /// Returns a copy of all bytes.
  [[nodiscard]] std::string text() const;

 private:
  using Block = std::vector<char>;

  void give_back(Block block);

  std::deque<Block> blocks_;
  std::vector<Block> ready_;
  std::size_t begin_ = 0;  ///< Index of the oldest byte within the first block.
  std::size_t size_ = 0;
};

}  // namespace sim
