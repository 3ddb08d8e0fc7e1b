#pragma once

#include <cstdint>

#include "planner/base/axis_vector.hpp"
#include "planner/base/coordinate.hpp"
#include "planner/base/step_position.hpp"
#include "planner/kinematics/rotary_machine.hpp"
#include "planner/kinematics/rotation.hpp"

namespace cnc::kinematics {

/// Computes the positions of the axes X Y Z of a five-axis machine from the position that a program
/// gives to the tip of the tool.
///
/// A position of the program is the position of the axes at which the tip would be at the same
/// point of the part if the rotary axes were at 0. So the positions of axes and program are equal
/// while the rotary axes are at 0. Rotary axes are always at the position that the program gives.
///
/// The computation is in single precision: a position is exact within 0.2 µm if the tip is at most
/// 500 mm away from the rotary axes (lever()).
class ToolCentre {
 public:
  /// Creates an object without rotary axes: the positions of axes and program are equal everywhere.
  ToolCentre() = default;
  /// @param tool_length distance from the machine's gauge point to the tip; G43.1, G43.4
  ToolCentre(const RotaryMachine& machine, Coordinate tool_length);

  /// Returns whether rotary axes move the tip.
  [[nodiscard]] bool active() const { return kHasFiveAxes && machine_.kind != RotaryKind::kNone; }
  [[nodiscard]] const RotaryMachine& machine() const { return machine_; }
  [[nodiscard]] Coordinate tool_length() const { return tool_length_; }

  /// Returns the position of the axes for a position of the program, or the position of the program
  /// for a position of the axes.
  [[nodiscard]] Position axes_for(const Position& program) const;
  [[nodiscard]] Position program_for(const Position& axes) const;

  /// Returns the position of the axes for a position of the program, in steps of the motors, to the
  /// fraction of a step.
  [[nodiscard]] AxisArray<StepPosition> axes_for(const AxisArray<StepPosition>& program,
                                                 const AxisArray<AxisScale>& scale) const;

  /// Returns the number of equal parts into which a path must be divided; at least 1. On each part
  /// neither rotary axis turns by more than 4 degrees.
  [[nodiscard]] std::uint32_t parts_of(const Position& from, const Position& end) const;

  /// A path of the program through a position, with its derivatives with respect to its length.
  struct Way {
    Position place{};
    AxisVector first{};   ///< First derivative: mm, or degrees for rotary axes, per unit of length.
    AxisVector second{};  ///< Second derivative, per square of the unit of length.
  };
  /// Returns the position of the axes X Y Z, relative to centre(), and its derivatives along a
  /// path.
  [[nodiscard]] PlaceJet axes_along(const Way& way) const;

  /// Returns the greatest distance of the tip from the rotary axes that turn the tool or the part,
  /// mm.
  /// @param reach_mm distance by which the program's position may be away from `place`
  [[nodiscard]] float lever(const Position& place, float reach_mm) const;
  /// Returns a bound of the third derivative of the positions of X Y Z with respect to the length
  /// of a path, 1/mm². The path has the given curvature, 1/mm.
  /// @param rate greatest rate of both rotary axes together, rad/mm
  [[nodiscard]] static float third_derivative(float lever_mm, float rate, float curvature);
  /// Returns the point to which the positions that axes_along() returns are relative.
  [[nodiscard]] const Position& centre() const { return centre_; }

  /// Returns the direction from the tip into the tool, relative to the part.
  [[nodiscard]] Vec3 direction(const Position& program) const;

 private:
  /// Position of X Y Z relative to the centre, and the angles of the rotary axes.
  struct Pose {
    Vec3 place = Vec3::Zero();
    SinCos tilt{0.0F, 1.0F};
    SinCos turn{0.0F, 1.0F};
  };

  [[nodiscard]] Pose pose_of(const Position& place) const;
  [[nodiscard]] Pose pose_of(const AxisArray<StepPosition>& place,
                             const AxisArray<AxisScale>& scale) const;
  [[nodiscard]] std::size_t tilting_axis() const { return index_of(machine_.tilting); }
  [[nodiscard]] std::size_t tilts_about() const { return tilting_axis() - kLinearAxisCount; }
  [[nodiscard]] bool has_turning_table() const;
  [[nodiscard]] bool has_tilting_table() const { return machine_.kind == RotaryKind::kTables; }
  [[nodiscard]] PlaceJet on_tables(const PlaceJet& from_centre,
                                   const AngleJet& tilt,
                                   const AngleJet& turn) const;
  [[nodiscard]] PlaceJet of_head(const AngleJet& tilt, const AngleJet& turn) const;
  [[nodiscard]] Vec3 shift(const Pose& program) const;
  [[nodiscard]] Vec3 shift_back(const Pose& axes) const;

  RotaryMachine machine_{};
  Coordinate tool_length_{};
  Position centre_{};  ///< Point about which tables turn, raised by the tool length; X Y Z.
  Vec3 tilt_from_turn_ = Vec3::Zero();  ///< Vector from the turning axis to the tilting axis.
  Vec3 tip_from_tilt_ = Vec3::Zero();   ///< Vector from the tilting axis of a head to the tip.
};

}  // namespace cnc::kinematics
