#include "planner/geometry/biarc.hpp"

#include "planner/geometry/biarc_formulas.hpp"

namespace cnc {
namespace {

struct SingleNumbers {
  /// Angle in radians below which the sine differs from the angle by at most 1e-9 of the angle:
  /// less than the last bit of a float.
  static constexpr float kSmallAngle = 1.0e-4F;
  /// Greatest |w| in radians (see make_biarc). Beyond it both arcs tend to half turns of unbounded
  /// length.
  static constexpr float kWidest = kPi - 1.0e-3F;
  static constexpr float kQuarterTurn = kHalfPi;
  static float angle_of(float y, float x) { return atan2_f(y, x); }
};

}  // namespace

float bulge_between(const Vec2& tangent, const Vec2& chord) {
  return biarc_formulas::bulge_of_tangent(tangent, chord);
}

Result<Biarc, BiarcError> make_biarc(const BiarcEnds& ends, float joint_share) {
  return biarc_formulas::biarc_at<SingleNumbers>(ends, joint_share);
}

}  // namespace cnc
