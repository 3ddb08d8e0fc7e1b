#pragma once

#include <optional>

#include "planner/path/circle_fan.hpp"

namespace cnc::path {

/// Coordinate frame of a fit: along the direction at its start, to the left of it, and upwards.
struct FitFrame {
  Vec3 ahead{1.0F, 0.0F, 0.0F};
  Vec3 left{0.0F, 1.0F, 0.0F};
  Vec3 up{0.0F, 0.0F, 1.0F};
  /// Shares of the tolerance to the left and upwards. The sum of their squares is 1. If `up_share`
  /// is 0, all points lie in the plane of `ahead` and `left`.
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

/// Returns a frame in space along a direction, for a path that is expected to bend towards another
/// direction.
/// @param ahead unit vector.
/// @param towards expected direction of the bend; null if no bend is expected
[[nodiscard]] FitFrame frame_in_space(const Vec3& ahead, const Vec3& towards);

/// A circle or line from the start of a fit, in the coordinates of the frame.
struct FitCircle {
  FanCircle left{};
  FanCircle up{};

  [[nodiscard]] bool straight() const { return left.curvature == 0.0F && up.curvature == 0.0F; }
  [[nodiscard]] Vec3 tangent() const { return {1.0F, left.slope, up.slope}; }
};

/// The set of all circles and lines from a start that pass a growing list of points and the chords
/// between them within a tolerance. It consists of two fans, or of one where everything is flat.
class CircleFit {
 public:
  void begin(const FitFrame& frame, float max_curvature);
  [[nodiscard]] const FitFrame& frame() const { return frame_; }
  [[nodiscard]] bool empty() const { return left_.empty() || (!frame_.flat() && up_.empty()); }

  /// Takes the next point, in the coordinates of the frame, and both ends of the chord to it.
  void pass(const Vec3& here, float within_mm);

  /// Circles that end at a point.
  struct Ending {
    FitCircle best{};  ///< A line if one fits, else the middle of all circles.
    /// The circle that begins in the direction of the frame, if one fits.
    std::optional<FitCircle> smooth{};
  };
  /// Returns the circles that end at `here`. Empty where no circle passes the points and ends
  /// there.
  [[nodiscard]] std::optional<Ending> ending_at(const Vec3& here) const;

 private:
  void keep_near(const Vec3& point, float within_mm, float chord_mm);

  FitFrame frame_{};
  CircleFan left_{};
  CircleFan up_{};
  Vec3 last_{0.0F, 0.0F, 0.0F};
  /// Greatest length of chords at the last point that is allowed for, mm.
  float chord_passed_ = 0.0F;
};

}  // namespace cnc::path
