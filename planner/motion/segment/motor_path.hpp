#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "planner/geometry/chord_frame.hpp"
#include "planner/motion/block/block.hpp"

namespace cnc::motion {

/// Where the motors are along one block: evaluates its line, arc or helix by
/// arc-length fraction, in fixed point (Q32.32 steps), to 20 nm at 4 m.
class MotorPath {
 public:
  /// A place on the block, for the motors to be asked about.
  struct Point {
    std::uint32_t fraction = 0;  ///< Of the block's length in Q32; its end is …
    bool at_end = false;         ///< … this.
    ChordPoint turn{};           ///< Of a block that turns.
  };

  /// One motor that moves on the block. An axis in the plane in which it turns goes along
  /// the chord and aside from it; any other evenly.
  class Motor {
   public:
    Motor() = default;
    Motor(std::size_t axis, StepPosition start, std::int64_t chord, float per_mm)
        : axis_{axis}, start_{start}, chord_{chord}, chord_per_mm_{nearest_float(chord) * per_mm} {}
    /// It lies in the plane in which the block turns. @param normal of the chord along it
    void turn(std::int64_t normal, float per_mm);

    [[nodiscard]] std::size_t axis() const { return axis_; }
    [[nodiscard]] StepPosition place(const Point& point) const {
      if (point.at_end) return StepPosition{start_.q32() + chord_.whole()};
      const std::int64_t way = turns_ ? turned(point.turn) : chord_.share(point.fraction);
      return StepPosition{start_.q32() + way};
    }
    /// Steps per mm of path; times the path speed it is steps/s.
    [[nodiscard]] float speed(const Point& point) const {
      if (!turns_) return chord_per_mm_;
      return chord_per_mm_ * point.turn.along_rate + normal_per_mm_ * point.turn.across_rate;
    }

   private:
    /// Q32.32 steps in two halves, both signed: products of 32 bits are one instruction.
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
      /// length · fraction / 2^32, exact but for the last bit.
      [[nodiscard]] std::int64_t share(std::uint32_t fraction) const {
        return std::int64_t{high} * fraction + ((std::int64_t{low} * fraction) >> 32);
      }
    };
    static std::int64_t product(std::int32_t a, std::int32_t b) { return std::int64_t{a} * b; }

    /// Steps from the start, as far along the chord and across it.
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
    Length normal_{};            ///< Of the chord, along this axis.
    float chord_per_mm_ = 0.0F;  ///< Steps of chord per mm of path.
    float normal_per_mm_ = 0.0F;
  };

  MotorPath() = default;
  MotorPath(const Block& block, const AxisArray<StepPosition>& start) { begin(block, start); }
  /// Another block.
  void begin(const Block& block, const AxisArray<StepPosition>& start);

  /// @param fraction of the block's length; 2^32 is its end, which is met exactly.
  [[nodiscard]] Point at(std::uint64_t fraction) const;

  /// The others stay where they are.
  [[nodiscard]] std::span<const Motor> moving() const { return {motors_.data(), count_}; }

 private:
  AxisArray<Motor> motors_{};
  std::size_t count_ = 0;
  ChordFrame frame_{};
  bool turns_ = false;
};

}  // namespace cnc::motion
