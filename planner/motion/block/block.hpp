#pragma once

#include <array>
#include <cstdint>

#include "planner/base/axes.hpp"
#include "planner/base/step_position.hpp"
#include "planner/geometry/arc_plane.hpp"
#include "planner/motion/block/output_changes.hpp"
#include "planner/motion/block/pixels.hpp"
#include "planner/motion/block/source_line.hpp"
#include "planner/motion/block/turning.hpp"

namespace cnc::motion {

/// An edge that a beam goes half a kerf beside: seen along its way, the beam is on this side.
enum class Beside : std::uint8_t { kNothing, kLeft, kRight };

/// The beam or spindle output that goes with a motion.
struct BeamCommand {
  float duty = 0.0F;           ///< 0…1 of full power at the programmed feed; a beam's light.
  bool follows_speed = false;  ///< M4: scaled by speed / programmed feed.
  Beside beside = Beside::kNothing;
  constexpr bool operator==(const BeamCommand&) const = default;
};

/// The planar part of a block that turns. For a straight block `half_sweep` is 0.
struct Turn {
  ArcPlane plane{};
  float half_sweep = 0.0F;   ///< Radians, positive counter-clockwise.
  float start_angle = 0.0F;  ///< Of the tangent at the start, in the plane.
  float plane_share = 1.0F;  ///< Plane speed / path speed; below 1 on a helix.
  float curvature = 0.0F;    ///< |κ| of the plane circle, 1/mm.
};

/// Limits that reach beyond the block they come from. The motion is the mean of
/// the plan over a window of time T, so the plan must keep within the limits of a
/// place from about v · T / 2 before it to as much behind it.
struct LimitZone {
  float length = 0.0F;           ///< mm; 0 is no zone.
  float speed_square = 1.0e12F;  ///< v² at most.
  float acceleration = 1.0e9F;   ///< mm/s² at most, of which turning takes a part.
  Turning turning{};
  constexpr bool operator==(const LimitZone&) const = default;
};

/// What the backward pass of the look-ahead knows at a place.
///
/// Under a window T, whoever speeds up must be able to go on level for T before
/// braking. With X, the v² on the braking curve extended beyond the caps that cut
/// it off, and a, the steepest braking ahead, that is so up to the speed
///   sqrt(X + a² T²) − a T,
/// because braking by a over the way v T takes 2 a v T from X. Up to a speed that
/// may be kept ahead there is no need for braking.
struct BrakingState {
  float speed_square = 0.0F;   ///< v² from which the rest can be driven.
  float commit_square = 0.0F;  ///< X.
  float steepest = 0.0F;       ///< a, mm/s².
  float kept = 0.0F;           ///< The speed that may be kept, mm/s; 0 without a window.
  constexpr bool operator==(const BrakingState&) const = default;
};

/// At most two that reach into a block from one of its ends.
using BlockZones = std::array<LimitZone, 2>;

/// One line, arc or helix as the planner keeps it: geometry in steps for
/// whoever makes the pulses, limits in mm and seconds for whoever plans speed.
///
/// Path length, speed and acceleration are measured in the Euclidean metric of
/// all six axes; for X Y Z motion that is millimetres along the tool path.
struct Block {
  AxisArray<StepPosition> end{};
  /// The chord turned a quarter turn left in its plane; see ChordFrame.
  AxisArray<StepPosition> normal{};
  Turn turn{};

  AxisArray<float> direction{};     ///< Unit tangent; for an arc only its part off the plane.
  float length = 0.0F;              ///< mm.
  float feed = 0.0F;                ///< Programmed speed along the path, mm/s; 0 is a rapid.
  bool from_rest = true;            ///< The machine stands still at its start.
  bool fixed_feed = false;          ///< Overrides of feed and rapid do not touch it.
  OutputChanges outputs{};          ///< At its start.
  float acceleration = 0.0F;        ///< mm/s², by the axes whose direction is constant.
  float speed_limit_square = 0.0F;  ///< From rates, step rates and centripetal acceleration.
  /// What the look-ahead finds; changes as blocks are added.
  BrakingState entry{};  ///< Of the backward pass, at its start.
  /// v² that it may be left with when all the way from the last rest is for speeding up.
  float reachable_square = 1.0e12F;
  BlockZones head{};  ///< From blocks before it.
  BlockZones tail{};  ///< From blocks behind it.

  BeamCommand beam{};
  RowPart row{};  ///< Where there is one, its pixels say the duty.
  SourceLine line{};

  [[nodiscard]] bool is_rapid() const { return feed <= 0.0F; }
  [[nodiscard]] bool turns() const { return turn.curvature > 0.0F; }
};

}  // namespace cnc::motion
