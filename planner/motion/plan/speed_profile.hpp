#pragma once

#include <array>
#include <cstddef>

#include "planner/motion/lookahead/braking.hpp"
#include "planner/motion/lookahead/plan_terms.hpp"

namespace cnc::motion {

/// A part of the speed profile with constant acceleration.
struct Phase {
  float start_speed = 0.0F;   ///< Speed at the start, mm/s.
  float acceleration = 0.0F;  ///< Acceleration along the path, mm/s²; negative when braking.
  float duration = 0.0F;      ///< Duration, s; 0 means that the machine is at rest.
  float distance = 0.0F;      ///< Distance along the path, mm.
  float end_speed_square = 0.0F;
  /// Distance from the end of the phase to the end of its last span, mm; 0 if both end together.
  float left = 0.0F;
  int passes = 0;  ///< Number of spans that end within the phase, without its last span.
};

/// State that limits a change of speed where jerk is limited. The first two fields are the times in
/// s for which the speed must still stay level before it may rise, or fall. At rest both times are
/// 0.
struct Patience {
  float before_speeding_up = 0.0F;
  float before_braking = 0.0F;
  /// Speed of the plan in mm/s when it last did not brake. The motion may still have this speed.
  float braking_from = 0.0F;
  /// True if an override has lowered the speed limits so far that braking after `before_braking` is
  /// too late to keep them. All limits of acceleration and jerk are still kept, because the plan
  /// before the override kept them.
  bool overtaken = false;
};

enum class Drive : std::uint8_t {
  kOn,    ///< Drive as fast as limits, feed and the path ahead allow.
  kHalt,  ///< Feed hold: slow down as hard as the limits allow.
};

/// Speed along the block that is being driven, as phases of constant acceleration.
///
/// The profile is the forward pass of the look-ahead. Within a span, the speed rises until it
/// reaches the greatest speed of the span (the cap) or the braking curve. The speed stays at the
/// cap, and then follows the braking curve. Under a time window T, the speed stops rising early
/// enough to be level for T before braking. Each phase is computed from the present state when it
/// is required. So after an override, a hold or added blocks, the caller just requests the next
/// phase.
class SpeedProfile {
 public:
  /// Starts the profile at the start of a block.
  /// @param exit state that must be reached at the end of the block
  /// @param speed_square v² at the start of the block
  void begin(const Block& block,
             const Limits& limits,
             const PlanTerms& terms,
             const BrakingState& exit,
             float speed_square);
  /// Computes the profile again after a change of the plan ahead, or of the limit zones that reach
  /// into the block. The position and the speed stay the same.
  void replan(const Block& block,
              const Limits& limits,
              const PlanTerms& terms,
              const BrakingState& exit);

  [[nodiscard]] bool at_end() const { return span_ == spans_.count(); }
  [[nodiscard]] float speed_square() const { return speed_square_; }
  [[nodiscard]] const BrakingState& exit() const { return exit_; }
  /// Returns whether the speed exceeds the cap, or is too high for braking in time if braking
  /// begins only after patience.before_braking.
  [[nodiscard]] bool too_fast(const Patience& patience) const;
  /// Returns whether the position is within a limit zone of a later block that `before` does not
  /// contain.
  [[nodiscard]] bool within_other_zones(const BlockZones& before) const;
  /// Returns whether there is a limit zone of a later block in which turning at the present speed
  /// uses all acceleration. Ignores a zone if `before` contains a zone that is at least as long and
  /// at least as strict for turning.
  [[nodiscard]] bool too_fast_to_turn(const BlockZones& before) const;
  /// Returns the limit zones of later blocks that the profile includes.
  [[nodiscard]] const BlockZones& tail() const { return spans_.tail(); }

  /// Returns the next phase from the present position and speed. A duration of 0 means that the
  /// machine is halted and at rest. @pre !at_end()
  [[nodiscard]] Phase next_phase(Drive drive, const Patience& patience = {}) const;

  /// Moves to the end of a phase that was driven completely.
  void complete(const Phase& phase) {
    span_ += phase.passes;
    move(phase.left, phase.end_speed_square);
  }
  /// Moves to the position `distance` mm before the end of `phase`, which was driven only up to
  /// this position.
  /// @param speed speed at that position, mm/s
  void stop_short(const Phase& phase, float distance, float speed);
  /// Corrects the distance to the end of the block, in mm. `left_of_block` is more exact than the
  /// sum of the distances of the phases. Has an effect only in the last span.
  void settle(float left_of_block) {
    if (span_ + 1 == spans_.count() && settles(left_of_block)) left_ = left_of_block;
  }
  /// Returns whether settle() is useful at this distance. Less than a micrometre before the end,
  /// the distance that the profile has added up is exact enough.
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
  /// Distance to the end of the present span, mm. It is measured from the end of the span, because
  /// braking ends there and requires exact digits. Near the end, a distance from the start would
  /// have fewer digits.
  float left_ = 0.0F;
  int span_ = 0;
};

}  // namespace cnc::motion
