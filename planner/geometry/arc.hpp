#pragma once

#include "planner/base/result.hpp"
#include "planner/base/units.hpp"
#include "planner/geometry/vector.hpp"

namespace cnc {

enum class ArcError {
  kChordTooShort,  ///< End points closer than `kShortestChord`: direction is noise.
  kSweepTooLarge,  ///< |bulge| > 1: more than half a turn, split it first.
};

/// A circular arc of at most half a turn, the one primitive of a tool path.
///
/// A straight line is an arc with bulge 0, so nothing downstream needs a
/// line/arc branch.
///
/// Held as end points plus bulge b = tan(sweep / 4), positive to the left,
/// rather than centre and angles: end points stay bit-exact when arcs are
/// joined, and a nearly straight arc has no far-away centre to lose digits in.
/// With h = sweep / 2: sin h = 2b / (1 + b²), cos h = (1 − b²) / (1 + b²), and
/// the chord is 2 R sin h.
class Arc {
 public:
  static constexpr Length kShortestChord{1.0e-6F};
  /// Slack for a half turn whose bulge was computed in single precision.
  static constexpr float kLargestBulge = 1.0F + 1.0e-5F;

  [[nodiscard]] static Result<Arc, ArcError> make(const Vec2& start, const Vec2& end, float bulge);

  [[nodiscard]] const Vec2& start() const { return start_; }
  [[nodiscard]] const Vec2& end() const { return end_; }
  [[nodiscard]] float bulge() const { return bulge_; }

  /// Signed 1/mm, positive when turning left. Exact zero for a line.
  [[nodiscard]] float curvature() const;

  /// Half the sweep in radians, signed like the bulge.
  [[nodiscard]] float half_sweep() const;

  /// Distance along the arc. Relative error below 1e-6 for every legal bulge
  /// (arc_test.cpp, LengthAgreesWithDoublePrecision).
  [[nodiscard]] Length length() const;

  /// Unit travel direction where the arc begins and where it ends.
  [[nodiscard]] Vec2 start_tangent() const;
  [[nodiscard]] Vec2 end_tangent() const;

  /// The same curve travelled backwards.
  [[nodiscard]] Arc reversed() const;

 private:
  Arc(const Vec2& start, const Vec2& end, float bulge) : start_{start}, end_{end}, bulge_{bulge} {}
  [[nodiscard]] Vec2 chord_turned_by_half_sweep(float direction) const;

  Vec2 start_;
  Vec2 end_;
  float bulge_;
};

}  // namespace cnc
