#include "host-sim/measure/course_meter.hpp"

#include <algorithm>
#include <cmath>

namespace sim {
namespace {

/// Number of windows without an edge after which every axis is at rest and all samples in memory
/// are equal.
constexpr double kQuietWindows = EdgeTrack::kLongestSettling + 4.0;

}  // namespace

CourseMeter::CourseMeter(double window_s, const Vector& start) : window_s_{window_s} {
  for (const double place : start) courses_.emplace_back(window_s, place);
}

void CourseMeter::add_edge(std::size_t axis, const AxisEdge& edge) {
  courses_[axis].add(edge);
  last_edge_s_ = edge.time_s;
}

void CourseMeter::advance(double time_s) {
  const double certain = time_s - courses_.front().lag_s();
  const double quiet = last_edge_s_ + kQuietWindows * window_s_;
  sample_until(std::min(certain, quiet));
  if (certain <= quiet) return;
  // A long pause contains no motion. The measurement continues at its end with an empty memory.
  count_ = 0;
  next_sample_s_ = certain;
}

void CourseMeter::finish() { sample_until(last_edge_s_ + kQuietWindows * window_s_); }

void CourseMeter::sample_until(double time_s) {
  const double period = window_s_ / static_cast<double>(kSamplesPerWindow);
  for (; next_sample_s_ < time_s; next_sample_s_ += period) {
    Vector sample{};
    for (std::size_t i = 0; i < sample.size(); ++i) {
      sample[i] = courses_[i].position_at(next_sample_s_);
    }
    take(sample);
  }
}

void CourseMeter::take(const Vector& sample) {
  if (count_ > 0) {
    const Vector& last = samples_[(count_ - 1) % kSamples];
    length_ += std::hypot(sample[0] - last[0], sample[1] - last[1], sample[2] - last[2]);
  }
  samples_[count_ % kSamples] = sample;
  ++count_;
  if (count_ >= kSamples) measure();
}

/// Returns the mean of the samples in a window. Window 0 is the oldest.
CourseMeter::Vector CourseMeter::mean(std::size_t window) const {
  Vector sum{};
  for (std::size_t i = 0; i < kSamplesPerWindow; ++i) {
    const Vector& sample = samples_[(count_ + window * kSamplesPerWindow + i) % kSamples];
    for (std::size_t axis = 0; axis < sum.size(); ++axis) sum[axis] += sample[axis];
  }
  for (double& component : sum) component /= static_cast<double>(kSamplesPerWindow);
  return sum;
}

void CourseMeter::measure() {
  const std::array<Vector, kWindows> means{mean(0), mean(1), mean(2)};
  Vector velocity{};
  Vector acceleration{};
  for (std::size_t i = 0; i < velocity.size(); ++i) {
    velocity[i] = (means[2][i] - means[1][i]) / window_s_;
    const double before = (means[1][i] - means[0][i]) / window_s_;
    acceleration[i] = (velocity[i] - before) / window_s_;
  }
  speed_ = std::max(speed_, std::hypot(velocity[0], velocity[1], velocity[2]));
  acceleration_ =
      std::max(acceleration_, std::hypot(acceleration[0], acceleration[1], acceleration[2]));
}

}  // namespace sim
