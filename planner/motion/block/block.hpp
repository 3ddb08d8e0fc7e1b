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

/// The side of an edge on which the beam is driven, at an offset of half a kerf. The side is seen
/// in the direction of travel.
enum class Beside : std::uint8_t { kNothing, kLeft, kRight };

/// The beam or spindle output that goes with a motion.
struct BeamCommand {
  /// Share of full power at the programmed feed, 0…1; of a beam, of its light.
  float duty = 0.0F;
  bool follows_speed = false;  ///< M4: the power is scaled by speed / programmed feed.
  Beside beside = Beside::kNothing;
  constexpr bool operator==(const BeamCommand&) const = default;
};

/// The planar part of a block that turns. For a straight block `half_sweep` is 0.
struct Turn {
  ArcPlane plane{};
  float half_sweep = 0.0F;   ///< In radians, positive counter-clockwise.
  float start_angle = 0.0F;  ///< Angle of the tangent at the start, in the plane, in radians.
  float plane_share = 1.0F;  ///< Plane speed / path speed; below 1 on a helix.
  float curvature = 0.0F;    ///< |κ| of the plane circle, 1/mm.
};

/// Limits of a block that reach into its neighbours. The motion is the mean of the plan over a
/// window of time T. So the plan must keep the limits of a position from about v · T / 2 before it
/// to about v · T / 2 after it.
struct LimitZone {
  float length = 0.0F;           ///< mm; 0 means that there is no zone.
  float speed_square = 1.0e12F;  ///< Greatest v².
  float acceleration = 1.0e9F;   ///< Greatest acceleration, mm/s²; turning takes a part of it.
  Turning turning{};
  constexpr bool operator==(const LimitZone&) const = default;
};

/// State of the look-ahead's backward pass at one point of the path.
///
/// Under a window T, a motion that speeds up must be able to keep its speed for T before it brakes.
/// X is v² on the braking curve, extended beyond the caps that cut the curve off. a is the steepest
/// braking ahead. The condition holds up to the speed
///   sqrt(X + a² T²) − a T,
/// because braking by a over the distance v T takes 2 a v T from X. Up to a speed that may be kept
/// ahead, no braking is needed.
struct BrakingState {
  float speed_square = 0.0F;   ///< Greatest v² from which the rest of the path can be driven.
  float commit_square = 0.0F;  ///< X, see above.
  float steepest = 0.0F;       ///< a, see above, in mm/s².
  float kept = 0.0F;           ///< Speed that may be kept ahead, mm/s; 0 without a window.
  constexpr bool operator==(const BrakingState&) const = default;
};

/// Zones that reach into a block from one of its ends; at most two.
using BlockZones = std::array<LimitZone, 2>;

/// One line, arc or helix as the planner keeps it. The geometry is in steps, for making pulses. The
/// limits are in mm and seconds, for planning the speed.
///
/// Path length, speed and acceleration are measured in the Euclidean metric of all six axes. For X
/// Y Z motion that is millimetres along the tool path.
struct Block {
  AxisArray<StepPosition> end{};
  /// The chord turned a quarter turn left in its plane; see ChordFrame.
  AxisArray<StepPosition> normal{};
  Turn turn{};

  AxisArray<float> direction{};     ///< Unit tangent; of an arc, only its part off the plane.
  float length = 0.0F;              ///< mm.
  float feed = 0.0F;                ///< Programmed speed along the path, mm/s; 0 is a rapid.
  bool from_rest = true;            ///< The machine is at rest at the start of the block.
  bool fixed_feed = false;          ///< Overrides of feed and rapid do not change the feed.
  OutputChanges outputs{};          ///< Changes at the start of the block.
  float acceleration = 0.0F;        ///< Limit by the axes of constant direction, mm/s².
  float speed_limit_square = 0.0F;  ///< Limit of v² by axis and step rates; Spans adds turning.
  /// The members from here to `tail` are results of the look-ahead. They change as blocks are
  /// added.
  BrakingState entry{};  ///< State of the backward pass at the start of the block.
  /// Greatest v² at the end of the block if the motion speeds up all the way from the last rest.
  float reachable_square = 1.0e12F;
  BlockZones head{};  ///< Zones of earlier blocks.
  BlockZones tail{};  ///< Zones of later blocks.

  BeamCommand beam{};
  RowPart row{};  ///< If row.any(), the pixels of the row set the duty.
  SourceLine line{};

  [[nodiscard]] bool is_rapid() const { return feed <= 0.0F; }
  [[nodiscard]] bool turns() const { return turn.curvature > 0.0F; }
};

}  // namespace cnc::motion
