#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "planner/motion/segment/segment.hpp"
#include "planner/motion/segment/segment_rate.hpp"

namespace cnc::motion {

/// Output over the slices of the segment that is being made: one even slope, or where the duty
/// jumps between two slices a level for each of them.
///
/// Slices beyond the levels that a segment has, or that LevelRate allows, share one with the energy
/// of all of them. Main loop only.
class SegmentPower {
 public:
  void begin() {
    count_ = 0;
    jumps_ = false;
  }
  /// Adds a slice in which the duty goes evenly from `start` to `end`, 0…1.
  void add(float start, float end, std::uint32_t duration_ns);
  /// Returns the duty with which the slice added last ends, 0…1. @pre one has been added
  [[nodiscard]] float end_duty() const { return end_; }
  /// Writes the output over the whole segment, of which the ticks are known.
  /// @param rest_ns planned time that segments before have left to it; negative: that they took
  /// @pre a slice has been added
  void write(std::int32_t rest_ns, Segment& segment) const;

 private:
  struct Piece {
    std::uint32_t duration_ns = 0;
    float energy_ns = 0.0F;  ///< Duty over time.

    [[nodiscard]] std::uint16_t output() const;
  };

  std::array<Piece, 1 + Segment::kMostLevels> pieces_{};
  std::size_t count_ = 0;
  float start_ = 0.0F;
  float end_ = 0.0F;
  bool jumps_ = false;
  LevelRate rate_{};
};

}  // namespace cnc::motion
