#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "planner/base/crc32.hpp"

namespace cnc {

/// Finds bits that turned over in memory which nobody writes meanwhile: goes
/// round its parts piece by piece and compares their checksum with the one that
/// was right. Main loop only.
class MemoryWatch {
 public:
  static constexpr std::size_t kMostParts = 8;
  using Part = std::span<const std::byte>;

  /// One part more. It stays where it is. @pre fewer than kMostParts
  void add(Part part);
  template <typename Object>
  void add_object(const Object& object) {
    add(std::as_bytes(std::span{&object, 1}));
  }

  /// What the parts hold now is right. Reads all of them: after each change.
  void accept() { expect(checksum()); }
  /// The same, where the CRC-32 of the parts, one after the other, is known already.
  void expect(std::uint32_t checksum);

  /// The CRC-32 of the parts when they were right.
  [[nodiscard]] std::uint32_t expected() const { return expected_; }

  /// Whether all parts still hold what is right. Reads all of them.
  [[nodiscard]] bool sound() const { return checksum() == expected_; }
  /// Reads at most this many bytes more. False when they end a round that found a
  /// difference. What turned over in a part behind is found in the next round.
  [[nodiscard]] bool check(std::size_t bytes);

 private:
  [[nodiscard]] std::uint32_t checksum() const;
  void begin_round();

  std::array<Part, kMostParts> parts_{};
  std::size_t count_ = 0;
  std::uint32_t expected_ = 0;  ///< Of no parts.
  // The present round.
  Crc32 sum_{};
  std::size_t part_ = 0;
  std::size_t place_ = 0;  ///< Within the part.
};

}  // namespace cnc
