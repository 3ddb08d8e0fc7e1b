#pragma once

#include <array>
#include <cstdint>

#include "planner/base/scalar_math.hpp"
#include "planner/base/step_position.hpp"
#include "planner/kerf/kerf_course.hpp"
#include "planner/motion/block/block.hpp"
#include "planner/motion/block/limits.hpp"

namespace cnc::motion {

/// Where a beam is that goes half a kerf beside an edge, while its kerf is wider or narrower than
/// that of the programmed speed: off the planned path, by half of the difference.
///
/// The shift is that difference times a vector of the plane. Beside an edge the vector is the
/// normal, so that the edge of the cut stays on the part's, plus whatever along the block makes it
/// lead to the shifted corner: at a joint both blocks have the vector to where their shifted ways
/// meet. Blocks that are not beside an edge lead from the last shift to the next or to none.
///
/// Nothing changes faster than a quarter of the way: where a machine brakes harder than a steep
/// kerf could be followed, or a corner is known late, the shift lags.
///
/// The motors are where plan and shift together say. Main loop only.
class KerfShift {
 public:
  /// From now on, or not any more for null. @param course outlives its use @pre settled()
  void follow(const kerf::KerfCourse* course) { course_ = course; }
  [[nodiscard]] bool follows() const { return course_ != nullptr; }
  [[nodiscard]] const kerf::KerfCourse& course() const { return *course_; }
  /// The motors are on the planned path now.
  void reset();
  /// They are.
  [[nodiscard]] bool settled() const { return steps_q32_[0] == 0 && steps_q32_[1] == 0; }

  // @pre follows()

  /// The plan comes to a block, and ends with it so far.
  void begin(const Block& block);
  /// Whether meet() was not called since.
  [[nodiscard]] bool ends() const { return ends_; }
  /// The block goes on to another.
  void meet(const Block& next);
  /// It has come to a place of the block.
  /// @param fraction of its length, 0…1
  /// @param way_mm from the last place
  /// @param heat of the programmed one, finite
  void move(float fraction, float way_mm, float heat, const Limits& limits);

  /// From the planned place to that of the motors.
  void add_to(AxisArray<StepPosition>& place) const;

 private:
  using Vector = std::array<float, 2>;

  void take_plane(const Block& block, Beside beside);
  [[nodiscard]] Vector vector() const;
  [[nodiscard]] static float approach(float from, float to, float share, float most);

  const kerf::KerfCourse* course_ = nullptr;
  Plane plane_ = Plane::kXY;
  Beside beside_ = Beside::kNothing;  ///< Of the block.
  bool ends_ = false;
  bool turns_ = false;
  float fraction_ = 0.0F;
  float start_angle_ = 0.0F;  ///< Of the tangent.
  float sweep_ = 0.0F;
  Vector exit_{1.0F, 0.0F};  ///< The tangent at the end.
  SinCos tangent_{0.0F, 1.0F};
  Vector now_{};        ///< The vector along the tangent and across it, to the left…
  Vector end_{};        ///< …and at the end of the block.
  float aside_ = 0.0F;  ///< mm.
  std::array<std::int64_t, 2> steps_q32_{};
};

}  // namespace cnc::motion
