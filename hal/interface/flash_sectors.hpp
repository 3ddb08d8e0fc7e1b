#pragma once

#include <cstddef>
#include <cstdint>

namespace hal {

/// Sectors of NOR flash of equal size, for a store that outlives power. Main
/// loop context; programming takes tens of microseconds, erasing hundreds of
/// milliseconds, and both stop the processor on chips that run from the same
/// flash: only while nothing moves.
///
/// Power may go at any moment. A word being programmed may then hold any subset
/// of its zeros, a sector being erased any words, and either may read unsteadily.
class FlashSectors {
 public:
  static constexpr std::uint32_t kErased = 0xFFFF'FFFF;

  [[nodiscard]] virtual std::size_t sector_count() const = 0;
  /// Words of 32 bits in each sector.
  [[nodiscard]] virtual std::size_t words_per_sector() const = 0;
  [[nodiscard]] virtual std::uint32_t read(std::size_t sector, std::size_t word) const = 0;
  /// Clears the bits that are zero in `value`; false when the flash refused or
  /// the word reads otherwise afterwards. A word may be programmed again: zeros
  /// that read unsteadily are firm then, and other zeros may be added.
  [[nodiscard]] virtual bool program(std::size_t sector, std::size_t word, std::uint32_t value) = 0;
  /// All words read kErased afterwards; false when the flash refused.
  [[nodiscard]] virtual bool erase(std::size_t sector) = 0;

 protected:
  ~FlashSectors() = default;
};

}  // namespace hal
