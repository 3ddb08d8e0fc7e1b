#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "host-sim/measure/edge_track.hpp"
#include "planner/base/axes.hpp"

namespace sim {

/// Measures speed, acceleration and length of the path in X Y Z. It takes ten samples per window of
/// the three axes' courses (EdgeTrack).
///
/// The speed is the norm of the difference of two means over neighbouring windows. The acceleration
/// is the norm of the second difference of three means. Both differences are weighted means of the
/// true vector with weights ≥ 0. Therefore they never exceed the greatest norm of this vector,
/// except by errors of the course: an error e adds at most 4 e / window² to the acceleration. On a
/// circle at angular speed ω, the measured acceleration is too low by the factor 1 − (ω window)² /
/// 8.
class CourseMeter {
 public:
  explicit CourseMeter(double window_s, const std::array<double, cnc::kLinearAxisCount>& start);

  void add_edge(std::size_t axis, const AxisEdge& edge);
  /// Takes all samples before this time.
  /// @pre all edges before this time were added
  void advance(double time_s);
  /// Takes the remaining samples. No more edges may follow.
  void finish();

  [[nodiscard]] double greatest_speed() const { return speed_; }
  [[nodiscard]] double greatest_acceleration() const { return acceleration_; }
  /// Returns the sum of the distances from sample to sample. For a circle, it is too low by the
  /// factor 1 − (ω window)² / 2400.
  [[nodiscard]] double length() const { return length_; }

 private:
  using Vector = std::array<double, cnc::kLinearAxisCount>;
  static constexpr std::size_t kSamplesPerWindow = 10;
  static constexpr std::size_t kWindows = 3;
  static constexpr std::size_t kSamples = kWindows * kSamplesPerWindow;

  void sample_until(double time_s);
  void take(const Vector& sample);
  void measure();
  [[nodiscard]] Vector mean(std::size_t window) const;

  double window_s_;
  std::vector<EdgeTrack> courses_;
  double next_sample_s_ = 0.0;
  double last_edge_s_ = 0.0;
  std::array<Vector, kSamples> samples_{};
  std::size_t count_ = 0;
  double speed_ = 0.0;
  double acceleration_ = 0.0;
  double length_ = 0.0;
};

}  // namespace sim
