#pragma once

#include <optional>

#include "planner/path/circle_fan.hpp"

namespace cnc::path {

/// How a fit sees the way from its start: along its direction, to the left of that, and upwards.
struct FitFrame {
  Vec3 ahead{1.0F, 0.0F, 0.0F};
  Vec3 left{0.0F, 1.0F, 0.0F};
  Vec3 up{0.0F, 0.0F, 1.0F};
  /// Parts of the tolerance to the left and upwards, the root of whose squares' sum is 1. Without
  /// any upwards nothing leaves the plane of the other two.
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

/// A frame in space along a direction, which expects the way to bend towards another.
/// @param ahead unit vector. @param towards null if nothing is expected
[[nodiscard]] FitFrame frame_in_space(const Vec3& ahead, const Vec3& towards);

/// A circle or line from the start of a fit, as the frame sees it.
struct FitCircle {
  FanCircle left{};
  FanCircle up{};

  [[nodiscard]] bool straight() const { return left.curvature == 0.0F && up.curvature == 0.0F; }
  [[nodiscard]] Vec3 tangent() const { return {1.0F, left.slope, up.slope}; }
};

/// All circles and lines from a start that pass a growing list of points and their chords within
/// a tolerance; two fans, or one where all of it is flat.
class CircleFit {
 public:
  void begin(const FitFrame& frame, float most_curvature);
  [[nodiscard]] const FitFrame& frame() const { return frame_; }
  [[nodiscard]] bool empty() const { return left_.empty() || (!frame_.flat() && up_.empty()); }

  /// Takes the next point, as the frame sees it, and both ends of the chord to it.
  void pass(const Vec3& here, float within_mm);

  /// Circles that end at a point.
  struct Ending {
    FitCircle best{};                   ///< A line if one will do, else the middle of all.
    std::optional<FitCircle> smooth{};  ///< The one that begins in the frame's direction.
  };
  /// Empty where no circle passes the points and ends there.
  [[nodiscard]] std::optional<Ending> ending_at(const Vec3& here) const;

 private:
  void keep_near(const Vec3& point, float within_mm, float chord_mm);

  FitFrame frame_{};
  CircleFan left_{};
  CircleFan up_{};
  Vec3 last_{0.0F, 0.0F, 0.0F};
  float chord_passed_ = 0.0F;  ///< mm, of the chords at the last point that are allowed for.
};

}  // namespace cnc::path
