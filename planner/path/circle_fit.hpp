#pragma once

#include <optional>

#include "planner/path/circle_fan.hpp"

namespace cnc::path {

/// Coordinate frame of a fit. Its axes point along the direction at the start of the fit, to the
/// left of it, and upwards.
struct FitFrame {
  Vec3 ahead{1.0F, 0.0F, 0.0F};
  Vec3 left{0.0F, 1.0F, 0.0F};
  Vec3 up{0.0F, 0.0F, 1.0F};
  /// Shares of the tolerance to the left and upwards. The sum of their squares is 1. If `up_share`
  /// is 0, all points are in the plane of `ahead` and `left`.
  float left_share = 1.0F;
  float up_share = 0.0F;

  [[nodiscard]] bool flat() const { return up_share == 0.0F; }
  [[nodiscard]] Vec3 seen(const Vec3& way) const {
    return {way.dot(ahead), way.dot(left), way.dot(up)};
  }
  [[nodiscard]] Vec3 way(const Vec3& seen) const {
    return seen.x() * ahead + seen.y() * left + seen.z() * up;
  }
};

/// Returns a frame in space along a direction.
/// @param ahead unit vector of the direction
/// @param towards direction in which the path is expected to bend; null if no bend is expected
[[nodiscard]] FitFrame frame_in_space(const Vec3& ahead, const Vec3& towards);

/// A circle or line through the start of a fit, in the coordinates of the frame.
struct FitCircle {
  FanCircle left{};
  FanCircle up{};

  [[nodiscard]] bool straight() const { return left.curvature == 0.0F && up.curvature == 0.0F; }
  [[nodiscard]] Vec3 tangent() const { return {1.0F, left.slope, up.slope}; }
};

/// The set of all circles and lines from a start that pass a growing list of points, and the chords
/// between these points, within a tolerance. It consists of two fans, or of one if all points are
/// in a plane.
class CircleFit {
 public:
  void begin(const FitFrame& frame, float max_curvature);
  [[nodiscard]] const FitFrame& frame() const { return frame_; }
  [[nodiscard]] bool empty() const { return left_.empty() || (!frame_.flat() && up_.empty()); }

  /// Adds the next point, in the coordinates of the frame, and the chord that leads to it.
  void pass(const Vec3& here, float within_mm);

  /// The circles of the set that end at a point.
  struct Ending {
    FitCircle best{};  ///< A line if one fits, otherwise the middle of all circles.
    /// The circle whose direction at the start is that of the frame, if such a circle fits.
    std::optional<FitCircle> smooth{};
  };
  /// Returns the circles of the set that end at `here`, or nothing if there are none.
  [[nodiscard]] std::optional<Ending> ending_at(const Vec3& here) const;

 private:
  void keep_near(const Vec3& point, float within_mm, float chord_mm);
  void keep_ahead(const Vec3& point, float within_mm);

  FitFrame frame_{};
  CircleFan left_{};
  CircleFan up_{};
  Vec3 last_{0.0F, 0.0F, 0.0F};
  /// Greatest length of a chord at the last point for which the set has been checked, mm.
  float chord_passed_ = 0.0F;
};

}  // namespace cnc::path
