#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "planner/base/crc32.hpp"

namespace cnc {

/// Finds flipped bits in memory that no code changes between two calls of accept(). It reads the
/// memory piece by piece in repeated passes. After each pass it compares the checksum of the bytes
/// read with the checksum of the correct content. Main loop only.
class MemoryWatch {
 public:
  static constexpr std::size_t kMaxParts = 8;
  using Part = std::span<const std::byte>;

  /// Adds a part of the memory to watch. The part must not move.
  /// @pre fewer than kMaxParts parts were added
  void add(Part part);
  template <typename Object>
  void add_object(const Object& object) {
    add(std::as_bytes(std::span{&object, 1}));
  }

  /// Accepts the present content as correct. Reads all parts; to be called after each change.
  void accept() { expect(checksum()); }
  /// Accepts the content whose CRC-32, over all parts in order, is `checksum`.
  void expect(std::uint32_t checksum);

  /// Returns the CRC-32 of the correct content.
  [[nodiscard]] std::uint32_t expected() const { return expected_; }

  /// Returns whether all parts still have the correct content. Reads all of them.
  [[nodiscard]] bool sound() const { return checksum() == expected_; }
  /// Reads at most `bytes` further bytes. Returns false if the read completes a pass and the
  /// checksum of the pass differs. If a bit flips after its byte was read, it is found in the next
  /// pass.
  [[nodiscard]] bool check(std::size_t bytes);

 private:
  [[nodiscard]] std::uint32_t checksum() const;
  void begin_round();

  std::array<Part, kMaxParts> parts_{};
  std::size_t count_ = 0;
  std::uint32_t expected_ = 0;  ///< CRC-32 of the correct content; initially of no bytes.
  // State of the present pass.
  Crc32 sum_{};
  std::size_t part_ = 0;
  std::size_t place_ = 0;  ///< Offset within the part, in bytes.
};

}  // namespace cnc
