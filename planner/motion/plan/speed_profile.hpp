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
  float duration = 0.0F;      ///< s; 0 means standing still.
  float distance = 0.0F;      ///< mm.
  float end_speed_square = 0.0F;
  float left = 0.0F;  ///< mm to the end of its last span after it; 0 ends the span.
  int passes = 0;     ///< So many whole spans before its last.
};

/// How long the course must stay level yet before the speed may change, s; jerk
/// asks for it. While standing there is no course, and nothing to wait for here.
struct Patience {
  float before_speeding_up = 0.0F;
  float before_braking = 0.0F;
  /// mm/s, the speed when the plan last did not brake: the motion may yet be as fast.
  float braking_from = 0.0F;
  /// An override has left less speed than braking after the wait can meet; what
  /// does not move must still be met, and will be, for it was before.
  bool overtaken = false;
};

enum class Drive : std::uint8_t {
  kOn,    ///< As fast as limits, feed and what lies ahead allow.
  kHalt,  ///< Feed hold: slow down as hard as the limits allow.
};

/// Speed along the block being driven, as phases of constant acceleration.
///
/// Forward pass of the look-ahead: within a span speed up until the cap or the
/// braking curve is met, hold the cap, then follow the braking curve. Under a
/// time window speeding up ends so early that the course is level for T before
/// braking. Phases are asked for one at a time from the present state, so a
/// change of mind (an override, a hold, more blocks) just asks again.
class SpeedProfile {
 public:
  /// Starts a block at its beginning with the given v².
  void begin(const Block& block,
             const Limits& limits,
             const PlanTerms& terms,
             const BrakingState& exit,
             float speed_square);
  /// Something ahead changed, or the zones that reach into the block; place and
  /// speed stay.
  void replan(const Block& block,
              const Limits& limits,
              const PlanTerms& terms,
              const BrakingState& exit);

  [[nodiscard]] bool at_end() const { return span_ == spans_.count(); }
  [[nodiscard]] float speed_square() const { return speed_square_; }
  [[nodiscard]] const BrakingState& exit() const { return exit_; }
  /// The speed is above what can be braked from, after the wait for it.
  [[nodiscard]] bool too_fast(const Patience& patience) const;
  /// The place lies in a zone from ahead that was not there before.
  [[nodiscard]] bool within_other_zones(const BlockZones& before) const;
  /// In a zone from ahead all is taken by turning at the present speed, and it was not
  /// asked for so far before.
  [[nodiscard]] bool too_fast_to_turn(const BlockZones& before) const;
  /// The zones from ahead that the plan knows of.
  [[nodiscard]] const BlockZones& tail() const { return spans_.tail(); }

  /// The next phase from the present place and speed. Duration 0: the machine
  /// stands still and wants to (halted). @pre !at_end()
  [[nodiscard]] Phase next_phase(Drive drive, const Patience& patience = {}) const;

  /// The whole phase was driven.
  void complete(const Phase& phase) {
    span_ += phase.passes;
    move(phase.left, phase.end_speed_square);
  }
  /// All but `distance` mm of it was; the speed is `speed` mm/s now.
  void stop_short(const Phase& phase, float distance, float speed);
  /// The place is so many mm from the end of the block, which is more exact than
  /// the sum of what phases left. Holds in the last span.
  void settle(float left_of_block) {
    if (span_ + 1 == spans_.count() && settles(left_of_block)) left_ = left_of_block;
  }
  /// Nearer to the end than a micrometre that sum is exact enough.
  [[nodiscard]] static bool settles(float left_of_block) { return left_of_block > 1.0e-3F; }
  /// mm to the end of the block after the phase.
  [[nodiscard]] float left_of_block(const Phase& phase) const {
    const int behind = span_ + phase.passes + 1;
    return spans_.boundary(spans_.count()) - spans_.boundary(behind) + phase.left;
  }

 private:
  /// @pre !at_end()
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
  [[nodiscard]] float steepest(Change change, float growing, float most_square) const;
  /// v² to be met at the end of the present span.
  [[nodiscard]] float end_target_square() const { return here().end.speed_square; }
  [[nodiscard]] float fall_from(float speed_square) const;
  [[nodiscard]] float planned_deceleration() const;
  void move(float left, float speed_square);

  Spans spans_{};
  /// The braking curve by spans, from the present span to the end of the block.
  std::array<BrakingPoint, Spans::kMostFineSpans> braking_{};
  static_assert(Spans::kMostSpans <= Spans::kMostFineSpans);
  BrakingState exit_{};
  float speed_square_ = 0.0F;
  /// mm to the end of the span. Counted from there, because braking ends there
  /// and needs its digits; from the start they would be lost in the length.
  float left_ = 0.0F;
  int span_ = 0;
};

}  // namespace cnc::motion
