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

/// The side of the programmed path on which the beam is driven, as seen in the direction of travel.
/// The offset of the beam from this path is half of a kerf.
enum class Beside : std::uint8_t { kNothing, kLeft, kRight };

/// The output of the beam or spindle during a motion.
struct BeamCommand {
  /// Output at the programmed feed as a share of full output, 0…1. For a beam with a power table it
  /// is the share of the greatest power (see PowerTable).
  float duty = 0.0F;
  bool follows_speed = false;  ///< M4: the power is scaled by speed / programmed feed.
  Beside beside = Beside::kNothing;
  constexpr bool operator==(const BeamCommand&) const = default;
};

/// The turning part of a block, in the plane of its arc. For a straight block `half_sweep` is 0.
struct Turn {
  ArcPlane plane{};
  /// Half of the angle by which the block turns, in radians, positive counter-clockwise.
  float half_sweep = 0.0F;
  float start_angle = 0.0F;  ///< Angle of the tangent at the start, in the plane, in radians.
  float plane_share = 1.0F;  ///< Speed in the plane / speed along the path; below 1 on a helix.
  float curvature = 0.0F;    ///< |κ| of the arc's circle in the plane, 1/mm.
};

/// Limits of a block that also hold on a part of the neighbouring blocks, under a time window.
///
/// The motion is the mean of the plan over a window of time T. So at the speed v, the plan must
/// keep the limits of a position from about v · T / 2 before this position to about v · T / 2 after
/// it.
struct LimitZone {
  /// Length of the zone, mm, measured from the joint through which it reaches into a neighbouring
  /// block; 0 means that there is no zone.
  float length = 0.0F;
  float speed_square = 1.0e12F;  ///< Greatest v², mm²/s².
  /// Greatest acceleration, mm/s², that turning and the change of speed may use together.
  float acceleration = 1.0e9F;
  Turning turning{};
  constexpr bool operator==(const LimitZone&) const = default;
};

/// State of the look-ahead's backward pass at one point of the path.
///
/// Under a time window T, a motion that speeds up must be able to keep its speed for T before it
/// brakes. Let X be v² at this point on the braking curve, which is extended beyond the speed
/// limits that cut it off. Let a be the greatest deceleration ahead. Then the motion may speed up
/// to
///   sqrt(X + a² T²) − a T,
/// because a level speed v over T uses the distance v T, over which the curve falls by 2 a v T.
///
/// The motion may always speed up to the speed `kept`. The path ahead allows this speed up to a
/// point where the bound above is at least `kept`.
struct BrakingState {
  /// Greatest v² from which the rest of the path can be driven, mm²/s².
  float speed_square = 0.0F;
  float commit_square = 0.0F;  ///< X: v² on the extended braking curve, mm²/s².
  float steepest = 0.0F;       ///< a: greatest deceleration ahead, mm/s².
  /// Speed that the motion can keep on the path ahead, mm/s; 0 without a time window.
  float kept = 0.0F;
  constexpr bool operator==(const BrakingState&) const = default;
};

/// The limit zones, at most two, that reach into a block through one of its ends.
using BlockZones = std::array<LimitZone, 2>;

/// One line, arc or helix in the planner. The geometry is in steps, because step pulses are
/// computed from it. The limits are in mm and seconds, because the speed is planned in these units.
///
/// Path length, speed and acceleration are measured in the Euclidean metric of all six axes. For a
/// motion of X Y Z alone, path length is in millimetres along the tool path.
struct Block {
  AxisArray<StepPosition> end{};
  /// The chord, turned to the left by a quarter turn in the plane of the arc; see ChordFrame.
  AxisArray<StepPosition> normal{};
  Turn turn{};

  /// Unit tangent of the path. On an arc, only its part outside the plane of the arc.
  AxisArray<float> direction{};
  float length = 0.0F;      ///< Length of the path, mm.
  float feed = 0.0F;        ///< Programmed speed along the path, mm/s; 0 for a rapid.
  bool from_rest = true;    ///< True if the machine is at rest at the start of the block.
  bool fixed_feed = false;  ///< True if feed and rapid overrides do not change the speed.
  OutputChanges outputs{};  ///< Output changes at the start of the block.
  /// Greatest acceleration along the path, mm/s², that is allowed by the axes outside the plane of
  /// an arc or, on a line, by all axes.
  float acceleration = 0.0F;
  /// Greatest v² that the axis rates and step rates allow, mm²/s². The class Spans adds the limits
  /// of turning.
  float speed_limit_square = 0.0F;
  /// The members from here to `tail` are results of the look-ahead. They change when later blocks
  /// are added.
  BrakingState entry{};  ///< State of the backward pass at the start of the block.
  /// Greatest v² at the end of the block if the motion speeds up all the way from the last rest.
  float reachable_square = 1.0e12F;
  BlockZones head{};  ///< Limit zones of earlier blocks that reach into this block.
  BlockZones tail{};  ///< Limit zones of later blocks that reach into this block.

  BeamCommand beam{};
  /// Part of a row of pixels that the block drives. If row.any(), the pixels set the duty.
  RowPart row{};
  SourceLine line{};

  [[nodiscard]] bool is_rapid() const { return feed <= 0.0F; }
  [[nodiscard]] bool turns() const { return turn.curvature > 0.0F; }
};

}  // namespace cnc::motion
