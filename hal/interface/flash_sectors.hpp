#pragma once

#include <cstddef>
#include <cstdint>

namespace hal {

/// Sectors of NOR flash of equal size, for a store that outlives power. Main loop context.
/// Programming a word takes tens of microseconds; erasing a sector takes up to two seconds. Both
/// stop the processor on chips that run from the same flash, so they are allowed only while nothing
/// moves.
///
/// Power may fail at any moment. If a word is then being programmed, any of its bits that were to
/// become zero may still be one. If a sector is being erased, its words may have any values. In
/// both cases bits may be unsteady.
class FlashSectors {
 public:
  static constexpr std::uint32_t kErased = 0xFFFF'FFFF;

  [[nodiscard]] virtual std::size_t sector_count() const = 0;
  /// Returns the number of 32-bit words in each sector.
  [[nodiscard]] virtual std::size_t words_per_sector() const = 0;
  [[nodiscard]] virtual std::uint32_t read(std::size_t sector, std::size_t word) const = 0;
  /// Clears the bits that are zero in `value`. Returns false if the flash refused the operation, or
  /// if the word then reads differently. A word may be programmed repeatedly: this makes its
  /// unsteady zeros firm and may add zeros.
  [[nodiscard]] virtual bool program(std::size_t sector, std::size_t word, std::uint32_t value) = 0;
  /// Erases a sector; afterwards all its words read kErased. Returns false if the flash refused the
  /// operation.
  [[nodiscard]] virtual bool erase(std::size_t sector) = 0;

 protected:
  ~FlashSectors() = default;
};

}  // namespace hal
