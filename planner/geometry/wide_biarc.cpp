#include "planner/base/wide_scalar_math.hpp"
#include "planner/geometry/biarc_formulas.hpp"

namespace cnc {
namespace {

struct DoubleNumbers {
  /// Angle in radians below which the sine differs from the angle by at most 1e-17 of the angle:
  /// less than the last bit of a double.
  static constexpr double kSmallAngle = 1.0e-8;
  /// Greatest |w| in radians (see make_biarc). Beyond it both arcs tend to half turns of unbounded
  /// length.
  static constexpr double kWidest = 3.14159265358979323846 - 1.0e-6;
  static constexpr double kQuarterTurn = 1.57079632679489661923;
  static double angle_of(double y, double x) { return wide_atan2(y, x); }
};

}  // namespace

double wide_bulge_between(const WideVec2& tangent, const WideVec2& chord) {
  return biarc_formulas::bulge_of_tangent(tangent, chord);
}

Result<WideBiarc, BiarcError> make_biarc(const WideBiarcEnds& ends, double joint_share) {
  return biarc_formulas::biarc_at<DoubleNumbers>(ends, joint_share);
}

}  // namespace cnc
