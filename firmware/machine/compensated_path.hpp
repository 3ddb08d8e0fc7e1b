#pragma once

#include "planner/compensation/compensator.hpp"
#include "planner/gcode/action.hpp"
#include "planner/kerf/kerf_course.hpp"
#include "planner/kerf/selected_table.hpp"

namespace cnc {

/// The path under G41 and G42: what these have set, the compensator that offsets the path, and the
/// kerf that gives its width.
///
/// Compensation begins with the entry, the first motion in the plane after G41 or G42. After G40
/// the machine is beside the programmed path until the exit, the first motion in the plane.
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

  // The kerf.

  /// Sets the kerf table that M190, G41 and G42 use from now on.
  /// @param table its view must outlive its use
  void use_kerf(const kerf::SelectedTable& table) { kerf_ = table; }
  [[nodiscard]] const kerf::SelectedTable& kerf() const { return kerf_; }
  /// Returns the course of the kerf from a condition on; valid until the next call.
  /// @pre the table has a kerf for the condition
  [[nodiscard]] const kerf::KerfCourse& course_from(const kerf::Condition& condition);

  // G41, G42 and G40.

  /// Sets compensation, for the entry to begin.
  /// @pre wanted.side is not kOn
  void set(const gcode::CutterCompensation& wanted, Plane plane) {
    wanted_ = wanted;
    wanted_plane_ = plane;
  }
  /// Ends what set() began; the exit still keeps the kerf.
  void cancel() { wanted_.side = gcode::CutterSide::kOn; }
  /// Returns whether compensation is active, from G41 or G42 until all motion up to G40 is taken.
  [[nodiscard]] bool compensates() const { return is_wanted() || active(); }
  /// Returns whether the width is that of the kerf, up to the end of the exit.
  [[nodiscard]] bool by_kerf() const { return wanted_.by_kerf; }
  /// Notes that the exit was driven.
  void end_exit() { wanted_.by_kerf = false; }
  /// Forgets everything but the kerf table.
  void reset() {
    wanted_ = {};
    clear();
  }

  // Elements of the programmed path.

  /// Begins compensation if `element` is the entry. Returns false if the entry is still to come,
  /// because `element` moves no axis of the plane.
  /// @pre the element moves
  [[nodiscard]] bool begin_with(const PathElement& element);
  /// Takes an element that is driven without an offset. If the machine is beside the path, the axes
  /// of the plane stay where they are.
  void move_apart(PathElement& element);
  /// Returns whether a straight motion to `end` leaves the machine beside the path, because it
  /// moves no axis of the plane. A motion of no length is an exit, too.
  [[nodiscard]] bool stays_beside(const Position& end) const;

 private:
  [[nodiscard]] bool is_wanted() const { return wanted_.side != gcode::CutterSide::kOn; }

  gcode::CutterCompensation wanted_{};  ///< State that G41 or G42 has set.
  Plane wanted_plane_ = Plane::kXY;     ///< Plane of G41 or G42.
  kerf::SelectedTable kerf_{};
  kerf::KerfCourse course_{};  ///< Course of the kerf while the motors follow it.
};

}  // namespace cnc
