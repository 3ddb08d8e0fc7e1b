#pragma once

#include <cstddef>
#include <deque>
#include <span>
#include <string>
#include <vector>

namespace sim {

/// First in, first out, of any length, in blocks: no byte moves however many come, so that a
/// thread that must not be late can keep megabytes.
///
/// Some blocks are kept ready, and have been touched before: where the system has to find memory
/// for each 4 KiB first, the loop reads at a quarter of its speed, on virtual machines above all.
class ByteBlocks {
 public:
  static constexpr std::size_t kBlock = std::size_t{1} << 20;
  /// Blocks that are kept ready: twice the 4 MiB that a sender's system may hold back.
  static constexpr std::size_t kReady = 8;

  /// @throw std::bad_alloc
  ByteBlocks();

  [[nodiscard]] std::size_t size() const { return size_; }

  /// @throw std::bad_alloc
  void append(std::span<const char> bytes);
  /// The oldest bytes as far as they lie together; empty only when all is empty.
  [[nodiscard]] std::span<const char> front() const;
  /// @pre count is at most front().size()
  void pop(std::size_t count);
  void clear();
  /// A copy of all.
  [[nodiscard]] std::string text() const;

 private:
  using Block = std::vector<char>;

  void give_back(Block block);

  std::deque<Block> blocks_;
  std::vector<Block> ready_;
  std::size_t begin_ = 0;  ///< In the first block.
  std::size_t size_ = 0;
};

}  // namespace sim
