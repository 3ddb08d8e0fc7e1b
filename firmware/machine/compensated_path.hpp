#pragma once

#include "planner/compensation/compensator.hpp"
#include "planner/gcode/action.hpp"
#include "planner/kerf/kerf_course.hpp"
#include "planner/kerf/selected_table.hpp"

namespace cnc {

/// The path under G41 and G42: the state that these words have set, the compensator that offsets
/// the path, and the kerf that determines the offset.
///
/// Compensation begins with the entry, the first motion in the plane after G41 or G42. After G40
/// the machine stays at the offset from the programmed path until the exit, the first motion in the
/// plane after G40.
class CompensatedPath : private compensation::Compensator {
 public:
  using Compensator::active;
  using Compensator::beside;
  using Compensator::clear;
  using Compensator::end;
  using Compensator::has_room;
  using Compensator::leave;
  using Compensator::programmed;
  using Compensator::put;
  using Compensator::refuse_to_leave;
  using Compensator::stand_at;
  using Compensator::take;

  // Functions for the kerf.

  /// Sets the kerf table that M190, G41 and G42 use from now on.
  /// @param table the memory that its view refers to must outlive its use
  void use_kerf(const kerf::SelectedTable& table) { kerf_ = table; }
  [[nodiscard]] const kerf::SelectedTable& kerf() const { return kerf_; }
  /// Returns the displacement of the kerf's edge as a function of the heat input, for the
  /// programmed condition. The result is valid until the next call.
  /// @pre the table has a kerf for the condition
  [[nodiscard]] const kerf::KerfCourse& course_from(const kerf::Condition& condition);

  // Functions for G41, G42 and G40.

  /// Stores the compensation of G41 or G42. The compensation begins with the entry.
  /// @pre wanted.side is not kOn
  void set(const gcode::CutterCompensation& wanted, Plane plane) {
    wanted_ = wanted;
    wanted_plane_ = plane;
  }
  /// Cancels the compensation that set() stored. by_kerf() does not change before the end of the
  /// exit.
  void cancel() { wanted_.side = gcode::CutterSide::kOn; }
  /// Returns whether the path is compensated: from G41 or G42 until all motion before G40 has been
  /// taken from the compensator.
  [[nodiscard]] bool compensates() const { return is_wanted() || active(); }
  /// Returns whether the kerf determines the offset. This holds until the end of the exit.
  [[nodiscard]] bool by_kerf() const { return wanted_.by_kerf; }
  /// Notes that the exit was driven, so that by_kerf() becomes false.
  void end_exit() { wanted_.by_kerf = false; }
  /// Resets everything except the kerf table.
  void reset() {
    wanted_ = {};
    clear();
  }

  // Functions for the elements of the programmed path.

  /// Begins compensation if `element` is the entry. Returns false if a later element will be the
  /// entry, because `element` moves no axis of the plane.
  /// @pre the element moves
  [[nodiscard]] bool begin_with(const PathElement& element);
  /// Prepares an element that is driven without an offset. If the machine is at the offset from the
  /// programmed path, removes the motion of the plane's axes from the element.
  void move_apart(PathElement& element);
  /// Returns whether the machine is still at the offset from the programmed path after a straight
  /// motion to `end`, because this motion moves no axis of the plane. A motion of length 0 counts
  /// as an exit, so the result is then false.
  [[nodiscard]] bool stays_beside(const Position& end) const;

 private:
  [[nodiscard]] bool is_wanted() const { return wanted_.side != gcode::CutterSide::kOn; }

  gcode::CutterCompensation wanted_{};  ///< State that G41 or G42 has set.
  Plane wanted_plane_ = Plane::kXY;     ///< Plane of G41 or G42.
  kerf::SelectedTable kerf_{};
  /// Displacement of the kerf's edge by heat input. The motors correct the path by it.
  kerf::KerfCourse course_{};
};

}  // namespace cnc
