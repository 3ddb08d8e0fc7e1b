#pragma once

#include <array>
#include <cstddef>

#include "planner/motion/lookahead/braking.hpp"
#include "planner/motion/lookahead/plan_terms.hpp"

namespace cnc::motion {

/// A stretch of constant acceleration.
struct Phase {
  float start_speed = 0.0F;   ///< mm/s.
  float acceleration = 0.0F;  ///< mm/s², signed.
  float duration = 0.0F;      ///< s; 0 means that the machine is at rest.
  float distance = 0.0F;      ///< mm.
  float end_speed_square = 0.0F;
  float left = 0.0F;  ///< mm from its end to the end of its last span; 0 ends the span.
  int passes = 0;     ///< Number of spans that the phase ends before its last one.
};

/// How long the speed must still stay level before it may change, in s, because jerk is limited. At
/// rest there is nothing to wait for.
struct Patience {
  float before_speeding_up = 0.0F;
  float before_braking = 0.0F;
  /// Speed in mm/s when the plan last did not brake: the motion may still be as fast.
  float braking_from = 0.0F;
  /// An override has lowered the speed below what braking after the wait can reach. Limits that the
  /// override does not change must still be kept, and will be, because the plan before kept them.
  bool overtaken = false;
};

enum class Drive : std::uint8_t {
  kOn,    ///< As fast as limits, feed and the path ahead allow.
  kHalt,  ///< Feed hold: slow down as hard as the limits allow.
};

/// Speed along the block being driven, as phases of constant acceleration.
///
/// This is the forward pass of the look-ahead. Within a span, the speed rises until it reaches the
/// cap or the braking curve, keeps the cap, then follows the braking curve. Under a time window,
/// the speed stops rising so early that it is level for T before braking. Each phase is computed
/// from the present state when it is needed. So after an override, a hold or more blocks, the
/// caller just requests the next phase.
class SpeedProfile {
 public:
  /// Starts a block at its beginning, with the given v².
  void begin(const Block& block,
             const Limits& limits,
             const PlanTerms& terms,
             const BrakingState& exit,
             float speed_square);
  /// Replaces the plan after a change ahead, or in the zones that reach into the block. Position
  /// and speed stay.
  void replan(const Block& block,
              const Limits& limits,
              const PlanTerms& terms,
              const BrakingState& exit);

  [[nodiscard]] bool at_end() const { return span_ == spans_.count(); }
  [[nodiscard]] float speed_square() const { return speed_square_; }
  [[nodiscard]] const BrakingState& exit() const { return exit_; }
  /// Returns whether the speed is too high for braking in time after the wait before braking.
  [[nodiscard]] bool too_fast(const Patience& patience) const;
  /// Returns whether the position lies in a zone of a later block that is not in `before`.
  [[nodiscard]] bool within_other_zones(const BlockZones& before) const;
  /// Returns whether there is a zone of a later block in which turning at the present speed takes
  /// all of the limits. A zone that `before` has as far does not count.
  [[nodiscard]] bool too_fast_to_turn(const BlockZones& before) const;
  /// Returns the zones of later blocks that the plan knows.
  [[nodiscard]] const BlockZones& tail() const { return spans_.tail(); }

  /// Returns the next phase from the present position and speed. A duration of 0 means that the
  /// machine is at rest and stays so (halted). @pre !at_end()
  [[nodiscard]] Phase next_phase(Drive drive, const Patience& patience = {}) const;

  /// Moves to the end of a phase that was driven as a whole.
  void complete(const Phase& phase) {
    span_ += phase.passes;
    move(phase.left, phase.end_speed_square);
  }
  /// Moves to the position `distance` mm before the end of a phase, where the speed is `speed`
  /// mm/s.
  void stop_short(const Phase& phase, float distance, float speed);
  /// Sets the distance to the end of the block, in mm. It is more exact than the sum of the
  /// distances that phases left. Takes effect only in the last span.
  void settle(float left_of_block) {
    if (span_ + 1 == spans_.count() && settles(left_of_block)) left_ = left_of_block;
  }
  /// Returns whether settle() is useful at this distance. Nearer to the end than a micrometre, the
  /// sum is exact enough.
  [[nodiscard]] static bool settles(float left_of_block) { return left_of_block > 1.0e-3F; }
  /// Returns the distance from the end of a phase to the end of the block, in mm.
  [[nodiscard]] float left_of_block(const Phase& phase) const {
    const int behind = span_ + phase.passes + 1;
    return spans_.boundary(spans_.count()) - spans_.boundary(behind) + phase.left;
  }

 private:
  /// Returns the braking point of the present span. @pre !at_end()
  [[nodiscard]] const BrakingPoint& here() const { return point_of(span_); }
  [[nodiscard]] const BrakingPoint& point_of(int span) const {
    return braking_[static_cast<std::size_t>(span)];
  }
  [[nodiscard]] Spans::Grid grid_for(const Block& block,
                                     const PlanTerms& terms,
                                     const BrakingState& exit) const;
  void lay_out(const Block& block,
               const Limits& limits,
               const PlanTerms& terms,
               const BrakingState& exit,
               float left_of_block,
               Spans::Grid grid);
  void brake_from_the_end(const Block& block, const Overrides& overrides);
  void find_span(float left_of_block);
  [[nodiscard]] Phase change_speed(const Patience& patience) const;
  [[nodiscard]] Phase speed_up() const;
  [[nodiscard]] Phase committed(const Phase& phase) const;
  [[nodiscard]] Phase level_or_follow(float longest_level) const;
  [[nodiscard]] Phase level_on() const;
  [[nodiscard]] Phase level_for(float seconds) const;
  [[nodiscard]] Phase brake_to(float target_square, const Patience& patience) const;
  [[nodiscard]] Phase phase_to(float end_square, float distance, float left) const;
  [[nodiscard]] float steepest(Change change, float growing, float max_square) const;
  /// Returns the v² that is required at the end of the present span.
  [[nodiscard]] float end_target_square() const { return here().end.speed_square; }
  [[nodiscard]] float fall_from(float speed_square) const;
  [[nodiscard]] float planned_deceleration() const;
  void move(float left, float speed_square);

  Spans spans_{};
  /// The braking curve, span by span, from the present span to the end of the block.
  std::array<BrakingPoint, Spans::kMaxFineSpans> braking_{};
  static_assert(Spans::kMaxSpans <= Spans::kMaxFineSpans);
  BrakingState exit_{};
  float speed_square_ = 0.0F;
  /// mm to the end of the span. It counts from that end, because braking ends there and needs the
  /// digits; counted from the start, they would be lost in the length.
  float left_ = 0.0F;
  int span_ = 0;
};

}  // namespace cnc::motion
