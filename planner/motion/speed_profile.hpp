#pragma once

#include <array>

#include "planner/motion/braking.hpp"

namespace cnc::motion {

/// A stretch of constant acceleration.
struct Phase {
  float start_speed = 0.0F;   ///< mm/s.
  float acceleration = 0.0F;  ///< mm/s², signed.
  float duration = 0.0F;      ///< s; 0 means standing still.
  float distance = 0.0F;      ///< mm.
  float end_speed_square = 0.0F;
  float left = 0.0F;  ///< mm to the end of its span after it; 0 ends the span.
};

enum class Drive : std::uint8_t {
  kOn,    ///< As fast as limits, feed and what lies ahead allow.
  kHalt,  ///< Feed hold: slow down as hard as the limits allow.
};

/// Speed along the block being driven, as phases of constant acceleration.
///
/// Forward pass of the look-ahead: within a span speed up until the cap or the
/// braking curve is met, hold the cap, then follow the braking curve. Phases
/// are asked for one at a time from the present state, so a change of mind (an
/// override, a hold, more blocks) just asks again.
///
/// The neighbours know phases only: the jerk-limited profile will hand out
/// shorter ones of the same kind.
class SpeedProfile {
 public:
  /// Starts a block at its beginning with the given v².
  void begin(const Block& block,
             const Limits& limits,
             const Overrides& overrides,
             float exit_square,
             float speed_square);
  /// Something ahead changed; place and speed stay.
  void replan(const Block& block, const Overrides& overrides, float exit_square);

  [[nodiscard]] bool at_end() const { return span_ == spans_.count(); }
  [[nodiscard]] float speed_square() const { return speed_square_; }
  [[nodiscard]] float exit_square() const { return exit_square_; }

  /// An axis reverses at or next to an end of the present span. @pre !at_end()
  [[nodiscard]] bool near_reversal() const { return spans_.near_reversal(span_); }

  /// The next phase from the present place and speed. Duration 0: the machine
  /// stands still and wants to (halted). @pre !at_end()
  [[nodiscard]] Phase next_phase(Drive drive) const;

  /// The whole phase was driven.
  void complete(const Phase& phase) { move(phase.left, phase.end_speed_square); }
  /// All but `distance` mm of it was; the speed is `speed` mm/s now.
  void stop_short(const Phase& phase, float distance, float speed);
  /// mm to the end of the block after the phase.
  [[nodiscard]] float left_of_block(const Phase& phase) const {
    return spans_.boundary(spans_.count()) - spans_.boundary(span_ + 1) + phase.left;
  }

 private:
  [[nodiscard]] Phase speed_up_or_follow() const;
  [[nodiscard]] Phase brake_to(float target_square) const;
  [[nodiscard]] Phase phase_to(float end_square, float distance, float left) const;
  [[nodiscard]] float steepest(Change change) const;
  [[nodiscard]] float end_target_square() const;
  [[nodiscard]] float planned_deceleration() const;
  void move(float left, float speed_square);

  Spans spans_{};
  std::array<BrakingPoint, Spans::kMostSpans> braking_{};
  float exit_square_ = 0.0F;
  float speed_square_ = 0.0F;
  /// mm to the end of the span. Counted from there, because braking ends there
  /// and needs its digits; from the start they would be lost in the length.
  float left_ = 0.0F;
  int span_ = 0;
};

}  // namespace cnc::motion
