#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "planner/geometry/chord_frame.hpp"
#include "planner/motion/block/block.hpp"

namespace cnc::motion {

/// Positions of the motors along one block. Evaluates its line, arc or helix at a fraction of its
/// length, in fixed point (Q32.32 steps), with an error of at most 20 nm at a length of 4 m.
class MotorPath {
 public:
  /// A point of the block at which motors can be evaluated.
  struct Point {
    std::uint32_t fraction = 0;  ///< Fraction of the block's length in Q32.
    bool at_end = false;  ///< True at the end of the block, which `fraction` cannot represent.
    ChordPoint turn{};    ///< Point relative to the chord, on a block that turns.
  };

  /// One motor that moves on the block. An axis in the plane in which the block turns moves along
  /// the chord and across it. Any other axis moves in proportion to the path length.
  class Motor {
   public:
    Motor() = default;
    Motor(std::size_t axis, StepPosition start, std::int64_t chord, float per_mm)
        : axis_{axis}, start_{start}, chord_{chord}, chord_per_mm_{nearest_float(chord) * per_mm} {}
    /// Adds the motion across the chord, for an axis in the plane in which the block turns.
    /// @param normal component of the chord's normal along the axis, in Q32.32 steps
    void turn(std::int64_t normal, float per_mm);

    [[nodiscard]] std::size_t axis() const { return axis_; }
    [[nodiscard]] StepPosition place(const Point& point) const {
      if (point.at_end) return StepPosition{start_.q32() + chord_.whole()};
      const std::int64_t way = turns_ ? turned(point.turn) : chord_.share(point.fraction);
      return StepPosition{start_.q32() + way};
    }
    /// Returns the signed steps of the motor per mm of path. Multiplied by the path speed in mm/s,
    /// they are the speed of the motor in steps/s.
    [[nodiscard]] float speed(const Point& point) const {
      if (!turns_) return chord_per_mm_;
      return chord_per_mm_ * point.turn.along_rate + normal_per_mm_ * point.turn.across_rate;
    }

   private:
    /// A length in Q32.32 steps as two signed 32-bit halves, because a product of 32-bit values is
    /// one instruction.
    struct Length {
      std::int32_t high = 0;  ///< Whole steps, rounded.
      std::int32_t low = 0;

      Length() = default;
      explicit Length(std::int64_t q32)
          : high{static_cast<std::int32_t>((q32 + (std::int64_t{1} << 31)) >> 32)},
            low{static_cast<std::int32_t>(q32)} {}
      [[nodiscard]] std::int64_t whole() const {
        return std::int64_t{high} * (std::int64_t{1} << 32) + low;
      }
      /// Returns length · fraction / 2^32, exact except for the last bit.
      [[nodiscard]] std::int64_t share(std::uint32_t fraction) const {
        return std::int64_t{high} * fraction + ((std::int64_t{low} * fraction) >> 32);
      }
    };
    static std::int64_t product(std::int32_t a, std::int32_t b) { return std::int64_t{a} * b; }

    /// Returns the distance, in Q32.32 steps, from the start to a point that is given along the
    /// chord and across it.
    [[nodiscard]] std::int64_t turned(const ChordPoint& turn) const {
      const std::int64_t high =
          product(chord_.high, turn.along_q30) + product(normal_.high, turn.across_q30);
      const std::int64_t low =
          product(chord_.low, turn.along_q30) + product(normal_.low, turn.across_q30);
      return high * 4 + (low >> 30);
    }

    std::size_t axis_ = 0;
    bool turns_ = false;
    StepPosition start_{};
    Length chord_{};
    Length normal_{};            ///< Component of the chord's normal along this axis.
    float chord_per_mm_ = 0.0F;  ///< Component of the chord in steps, per mm of path.
    float normal_per_mm_ = 0.0F;
  };

  MotorPath() = default;
  MotorPath(const Block& block, const AxisArray<StepPosition>& start) { begin(block, start); }
  /// Replaces the block by another one, which the motors begin at `start`.
  void begin(const Block& block, const AxisArray<StepPosition>& start);

  /// Returns the point at a fraction of the block's length. 2^32 is the end, which is exact.
  [[nodiscard]] Point at(std::uint64_t fraction) const;

  /// Returns the motors that move on the block. All other motors stay at their positions.
  [[nodiscard]] std::span<const Motor> moving() const { return {motors_.data(), count_}; }

 private:
  AxisArray<Motor> motors_{};
  std::size_t count_ = 0;
  ChordFrame frame_{};
  bool turns_ = false;
};

}  // namespace cnc::motion
