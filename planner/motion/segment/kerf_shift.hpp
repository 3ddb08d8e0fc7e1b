#pragma once

#include <array>
#include <cstdint>

#include "planner/base/scalar_math.hpp"
#include "planner/base/step_position.hpp"
#include "planner/kerf/kerf_course.hpp"
#include "planner/motion/block/block.hpp"
#include "planner/motion/block/limits.hpp"

namespace cnc::motion {

/// Shifts a beam that is driven at an offset of half a kerf from an edge of the part. While the
/// present kerf is wider or narrower than the kerf at the programmed speed, the beam is driven off
/// the planned path by half of the difference.
///
/// The shift is half of the difference times a vector in the plane of the path. On a block next to
/// an edge, the component of the vector across the path is the unit normal. So the edge of the cut
/// stays on the edge of the part. At a joint of two such blocks, a component along the path is
/// added, so that the vectors of both blocks lead to the point where their shifted paths meet. On a
/// block that is not next to an edge, the vector changes from the vector of the previous block to
/// the vector of the next block. If the next block is not next to an edge either, the vector
/// changes to zero.
///
/// While the plan drives a distance, neither a change of the shift's length nor a change of the
/// vector moves the beam by more than a quarter of this distance. So the shift lags where hard
/// braking changes the kerf too fast, or where the block after a corner becomes known late.
///
/// The position of the motors is the planned position plus the shift. Main loop only.
class KerfShift {
 public:
  /// Follows `course` from now on; null stops following.
  /// @param course must outlive its use
  /// @pre settled()
  void follow(const kerf::KerfCourse* course) { course_ = course; }
  [[nodiscard]] bool follows() const { return course_ != nullptr; }
  [[nodiscard]] const kerf::KerfCourse& course() const { return *course_; }
  /// Sets the shift to zero: the motors are on the planned path now.
  void reset();
  /// Returns whether the motors are on the planned path.
  [[nodiscard]] bool settled() const { return steps_q32_[0] == 0 && steps_q32_[1] == 0; }

  // The functions below require follows().

  /// Begins a block of the plan. The block counts as the last one until meet() is called.
  void begin(const Block& block);
  /// Returns whether the present block counts as the last one: meet() was not called since begin().
  [[nodiscard]] bool ends() const { return ends_; }
  /// Prepares for `next`, the block after the present one.
  void meet(const Block& next);
  /// Moves to a position on the block, and computes the shift there.
  /// @param fraction position as a fraction of the block's length, 0…1
  /// @param way_mm distance from the previous position, mm
  /// @param heat heat input divided by the programmed heat input, finite
  void move(float fraction, float way_mm, float heat, const Limits& limits);

  /// Adds the shift to `place`, a planned position, which becomes the position of the motors.
  void add_to(AxisArray<StepPosition>& place) const;

 private:
  using Vector = std::array<float, 2>;

  void take_plane(const Block& block, Beside beside);
  [[nodiscard]] Vector vector() const;
  [[nodiscard]] static float approach(float from, float to, float share, float most);

  const kerf::KerfCourse* course_ = nullptr;
  Plane plane_ = Plane::kXY;
  Beside beside_ = Beside::kNothing;  ///< Side of the beam on the present block.
  bool ends_ = false;
  bool turns_ = false;
  float fraction_ = 0.0F;
  float start_angle_ = 0.0F;  ///< Angle of the tangent at the start of the block, rad.
  float sweep_ = 0.0F;
  Vector exit_{1.0F, 0.0F};  ///< Tangent at the end of the block.
  SinCos tangent_{0.0F, 1.0F};
  Vector now_{};        ///< Present vector: components along the tangent and to its left.
  Vector end_{};        ///< Vector at the end of the block, relative to the tangent there.
  float aside_ = 0.0F;  ///< Factor of the vector: half of the difference of the kerfs, mm.
  std::array<std::int64_t, 2> steps_q32_{};
};

}  // namespace cnc::motion
