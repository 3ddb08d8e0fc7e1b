#pragma once

#include <algorithm>
#include <cstdint>

#include "planner/base/coordinate.hpp"
#include "planner/base/truncate.hpp"
#include "planner/motion/block/block.hpp"

namespace cnc::motion {

/// Distance along a path of many blocks, in units of 2^-36 mm. Sums and differences of integers are
/// exact, however long the path is. An arc of 10 nm still has 687,000 units.
using PathUnits = std::int64_t;

inline constexpr float kUnitsPerMm = 68'719'476'736.0F;
inline constexpr float kMmPerUnit = 1.0F / kUnitsPerMm;

/// Converts mm to units, rounded down. @pre 0 ≤ mm < 2^27
[[nodiscard]] PathUnits to_units(float mm);
[[nodiscard]] inline float to_mm(PathUnits units) { return nearest_float(units) * kMmPerUnit; }

/// Returns the distance in nanometres, rounded down. @pre 0 ≤ units < 2^59
[[nodiscard]] constexpr Coordinate to_coordinate(PathUnits units) {
  return Coordinate{((units >> 16) * 1'000'000) >> 20};
}

/// Returns the length of a block in units. The length is at least 1, so that the start and the end
/// of a block differ.
[[nodiscard]] inline PathUnits length_in_units(const Block& block) {
  return std::max<PathUnits>(1, to_units(block.length));
}

/// Converts positions within a block to fractions of the block's length in Q32, where 2^32 is the
/// end. The fraction grows monotonically with the position. Its error is at most 2^-31 of the
/// length, and zero at both ends.
class BlockFraction {
 public:
  static constexpr std::uint64_t kEnd = std::uint64_t{1} << 32;

  BlockFraction() = default;
  explicit BlockFraction(PathUnits length) : length_{length} {}

  /// Returns the fraction of the length at a position. @pre 0 ≤ place ≤ length
  [[nodiscard]] std::uint64_t of(PathUnits place) {
    if (place >= length_) return kEnd;
    if (reciprocal_q31_ == 0) divide();
    const auto scaled = static_cast<std::uint32_t>(place >> right_) << left_;
    return (std::uint64_t{scaled} * reciprocal_q31_) >> 31;
  }

 private:
  void divide() {
    auto scaled = static_cast<std::uint64_t>(length_);
    while (scaled >= kEnd) {
      scaled >>= 1;
      ++right_;
    }
    while (scaled < kEnd / 2) {
      scaled <<= 1;
      ++left_;
    }
    // The reciprocal is rounded down, so that a position before the end has a fraction below kEnd.
    reciprocal_q31_ = static_cast<std::uint32_t>(((std::uint64_t{1} << 63) - 1) / scaled);
  }

  PathUnits length_ = 1;
  /// Reciprocal of the length. It stays 0 until the first position within the block is converted,
  /// because the division is slow.
  std::uint32_t reciprocal_q31_ = 0;
  unsigned right_ = 0;
  unsigned left_ = 0;
};

}  // namespace cnc::motion
