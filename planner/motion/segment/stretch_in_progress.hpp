#pragma once

#include <cstdint>

#include "planner/motion/plan/phase_course.hpp"

namespace cnc::motion {

/// The stretch of the motion that is being cut into slices. Stores the place where the stretch
/// starts and the time that has passed since then. Times are in ns from the start of the stretch.
/// Places are distances from the start of the front block, in path units.
class StretchInProgress {
 public:
  /// Begins another stretch at the place `from`. @pre stretch.lasts()
  void begin(const Stretch& stretch, PathUnits from) {
    course_.begin(stretch);
    from_ = from;
    elapsed_ns_ = 0;
  }
  /// Moves the origin of places to the start of the next block, because the front block has ended.
  /// @param length length of the block that has ended
  void leave_block(PathUnits length) { from_ -= length; }
  /// Sets the time that has passed to `ns`.
  void pass_until(std::uint32_t ns) { elapsed_ns_ = ns; }
  /// Ends the stretch at `place`: all of its time has passed.
  void end_at(PathUnits place) {
    elapsed_ns_ = static_cast<std::uint32_t>(course_.duration_ns());
    from_ = place - course_.whole().way;
  }

  /// Returns whether time and distance of the stretch are used up when the motion is at `place`.
  /// The distance is checked, too, because a stretch may have a few units left at the end of its
  /// time.
  [[nodiscard]] bool is_over(PathUnits place) const {
    return place == from_ + course_.whole().way && elapsed_ns_ >= course_.duration_ns();
  }
  [[nodiscard]] std::uint32_t elapsed_ns() const { return elapsed_ns_; }
  [[nodiscard]] std::uint32_t left_ns() const {
    return static_cast<std::uint32_t>(course_.duration_ns()) - elapsed_ns_;
  }
  [[nodiscard]] PathUnits place_after(std::uint32_t ns) { return from_ + course_.way_after(ns); }
  /// Returns the speed at the time `ns`, in mm/s.
  [[nodiscard]] float speed_after(std::uint32_t ns) const { return course_.speed_after(ns); }
  /// Returns the time from the start of the stretch, in ns, at which the motion has driven the
  /// distance `way` from its present position.
  [[nodiscard]] std::uint32_t time_after(PathUnits way) const {
    return elapsed_ns_ + static_cast<std::uint32_t>(course_.time_of(way, elapsed_ns_));
  }
  /// Returns the acceleration, in mm/s².
  [[nodiscard]] float acceleration() const { return course_.whole().acceleration; }

 private:
  PhaseCourse course_{};
  PathUnits from_ = 0;  ///< Place of the stretch's start; negative in an earlier block.
  std::uint32_t elapsed_ns_ = 0;
};

}  // namespace cnc::motion
