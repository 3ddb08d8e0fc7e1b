#pragma once

#include <cstdint>

#include "planner/base/axis_vector.hpp"
#include "planner/base/coordinate.hpp"
#include "planner/base/step_position.hpp"
#include "planner/kinematics/rotary_machine.hpp"
#include "planner/kinematics/rotation.hpp"

namespace cnc::kinematics {

/// Where the axes X Y Z of a five-axis machine have to be so that the tip of its tool is where a
/// program says.
///
/// A program's place is in machine coordinates of a machine whose rotary axes are at 0: there both
/// are the same. Rotary axes are where the program says in any case.
///
/// Computed in single precision: for levers up to 500 mm a place is within 0.2 µm.
class ToolCentre {
 public:
  /// Both places are the same everywhere.
  ToolCentre() = default;
  /// @param tool_length_mm from the machine's gauge point to the tip; G43.1, G43.4
  ToolCentre(const RotaryMachine& machine, Coordinate tool_length);

  /// Returns whether rotary axes move the tip.
  [[nodiscard]] bool active() const { return kHasFiveAxes && machine_.kind != RotaryKind::kNone; }
  [[nodiscard]] const RotaryMachine& machine() const { return machine_; }
  [[nodiscard]] Coordinate tool_length() const { return tool_length_; }

  /// Returns the place of the axes for a place of the program, and the other way round.
  [[nodiscard]] Position axes_for(const Position& program) const;
  [[nodiscard]] Position program_for(const Position& axes) const;

  /// Returns the same in steps of the motors, to the fraction of a step.
  [[nodiscard]] AxisArray<StepPosition> axes_for(const AxisArray<StepPosition>& program,
                                                 const AxisArray<AxisScale>& scale) const;

  /// Returns into how many parts of one length a way is to be divided so that neither rotary axis
  /// turns by more than 4 degrees on any of them; at least 1.
  [[nodiscard]] std::uint32_t parts_of(const Position& from, const Position& end) const;

  /// A way of the program through a place, with its derivatives by its length.
  struct Way {
    Position place{};
    AxisVector first{};   ///< mm, degrees for rotary axes, by the unit of length.
    AxisVector second{};  ///< The same by the square of that unit.
  };
  /// Returns how the axes X Y Z move along it; their place is seen from centre().
  [[nodiscard]] PlaceJet axes_along(const Way& way) const;

  /// Returns the greatest distance of the tip from what turns it or the part under it, mm.
  /// @param reach_mm length by which the program's place may be away from `place`
  [[nodiscard]] float lever(const Position& place, float reach_mm) const;
  /// Returns a bound of the third derivative of the axes X Y Z along ways of a curvature: 1/mm².
  /// @param rate greatest rate of both rotary axes together, rad/mm
  [[nodiscard]] static float third_derivative(float lever_mm, float rate, float curvature);
  /// Returns the place that axes_along() sees places from.
  [[nodiscard]] const Position& centre() const { return centre_; }

  /// Returns the direction from the tip into the tool, as the part sees it.
  [[nodiscard]] Vec3 direction(const Position& program) const;

 private:
  /// Where X Y Z are as seen from the centre, and how the rotary axes stand.
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
  Position centre_{};  ///< The point that tables turn about, raised by the tool; X Y Z.
  Vec3 tilt_from_turn_ = Vec3::Zero();  ///< From the turning axis to the tilting one.
  Vec3 tip_from_tilt_ = Vec3::Zero();   ///< From the tilting axis of a head to the tip.
};

}  // namespace cnc::kinematics
