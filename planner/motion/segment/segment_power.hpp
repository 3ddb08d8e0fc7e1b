#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "planner/motion/segment/segment.hpp"
#include "planner/motion/segment/segment_rate.hpp"

namespace cnc::motion {

/// Output over the slices of the segment that is being made. The output is one linear slope or, if
/// the duty jumps between two slices, one level for each slice.
///
/// If there are more slices than a segment has levels, or than LevelRate allows, several slices
/// share one level with the same total energy. Main loop only.
class SegmentPower {
 public:
  void begin() {
    count_ = 0;
    jumps_ = false;
  }
  /// Adds a slice in which the duty, 0…1, changes linearly from `start` to `end`.
  void add(float start, float end, std::uint32_t duration_ns);
  /// Returns the duty at the end of the slice that was added last, 0…1. @pre a slice has been added
  [[nodiscard]] float end_duty() const { return end_; }
  /// Writes the output of all slices to `segment`.
  /// @param rest_ns planned time that earlier segments have left to this one; a negative value is
  /// time that they have taken in advance
  /// @pre a slice has been added, and the ticks of `segment` are set
  void write(std::int32_t rest_ns, Segment& segment) const;

 private:
  struct Piece {
    std::uint32_t duration_ns = 0;
    float energy_ns = 0.0F;  ///< Integral of the duty over time, ns.

    [[nodiscard]] std::uint16_t output() const;
  };

  std::array<Piece, 1 + Segment::kMaxLevels> pieces_{};
  std::size_t count_ = 0;
  float start_ = 0.0F;
  float end_ = 0.0F;
  bool jumps_ = false;
  LevelRate rate_{};
};

}  // namespace cnc::motion
