#pragma once

#include <cstdint>

#include "planner/motion/plan/phase_course.hpp"

namespace cnc::motion {

/// The stretch of the motion that is being cut into slices: its start on the path, and the time of
/// it that has passed. Times are ns from its start; places are distances from the start of the
/// front block.
class StretchInProgress {
 public:
  /// Begins another stretch at the place `from`. @pre the stretch lasts
  void begin(const Stretch& stretch, PathUnits from) {
    course_.begin(stretch);
    from_ = from;
    elapsed_ns_ = 0;
  }
  /// Counts places from the start of the next block: the front block, of this length, has ended.
  void leave_block(PathUnits length) { from_ -= length; }
  /// Lets `ns` from the start pass.
  void pass_until(std::uint32_t ns) { elapsed_ns_ = ns; }
  /// Lets all of its time pass; it ends at `place`.
  void end_at(PathUnits place) {
    elapsed_ns_ = static_cast<std::uint32_t>(course_.duration_ns());
    from_ = place - course_.whole().way;
  }

  /// Returns whether nothing is left, if the motion is at `place`. At its end, a stretch may have
  /// no time left for its last few units of distance.
  [[nodiscard]] bool is_over(PathUnits place) const {
    return place == from_ + course_.whole().way && elapsed_ns_ >= course_.duration_ns();
  }
  [[nodiscard]] std::uint32_t elapsed_ns() const { return elapsed_ns_; }
  [[nodiscard]] std::uint32_t left_ns() const {
    return static_cast<std::uint32_t>(course_.duration_ns()) - elapsed_ns_;
  }
  [[nodiscard]] PathUnits place_after(std::uint32_t ns) { return from_ + course_.way_after(ns); }
  /// Returns the speed after `ns`, in mm/s.
  [[nodiscard]] float speed_after(std::uint32_t ns) const { return course_.speed_after(ns); }
  /// Returns the time at which another `way` is driven.
  [[nodiscard]] std::uint32_t time_after(PathUnits way) const {
    return elapsed_ns_ + static_cast<std::uint32_t>(course_.time_of(way, elapsed_ns_));
  }
  /// Returns the acceleration, in mm/s².
  [[nodiscard]] float acceleration() const { return course_.whole().acceleration; }

 private:
  PhaseCourse course_{};
  PathUnits from_ = 0;  ///< Place of the start; below 0 in an earlier block.
  std::uint32_t elapsed_ns_ = 0;
};

}  // namespace cnc::motion
