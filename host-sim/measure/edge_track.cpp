#include "host-sim/measure/edge_track.hpp"

#include <algorithm>
#include <cmath>

namespace sim {
namespace {

/// Least distance of two kept edges, as a share of a window. A closer edge replaces the edge before
/// it. At an acceleration a, the chord between two kept edges is off by (window / 40)² a / 8, far
/// below a step.
constexpr double kSpacing = 1.0 / 40.0;

/// Speed at the first edge after a rest, divided by the mean speed up to the second edge. For x = a
/// t²/2, the edges are at 1/2 and 3/2 steps, and the ratio is √3 − 1.
constexpr double kSpeedAtRestingEdge = 0.7320508;

}  // namespace

void EdgeTrack::add(const AxisEdge& edge) {
  const std::size_t count = edges_.size();
  const bool crowded = count >= 2 && edge.time_s - edges_[count - 2].time_s < kSpacing * window_s_;
  if (crowded) {
    edges_.back() = edge;
  } else {
    edges_.push_back(edge);
  }
}

double EdgeTrack::position_at(double time_s) {
  while (edges_.size() > 2 && edges_[2].time_s <= time_s) edges_.pop_front();
  if (edges_.empty()) return start_;
  if (time_s < edges_.front().time_s) return leaving(0, time_s);
  const std::size_t index = edges_.size() > 1 && edges_[1].time_s <= time_s ? 1 : 0;
  return between(index, time_s);
}

/// Returns the mean speed from an edge to the next one; 0 at the last edge.
double EdgeTrack::speed_after(std::size_t index) const {
  if (index + 1 >= edges_.size()) return 0.0;
  const AxisEdge& from = edges_[index];
  const AxisEdge& to = edges_[index + 1];
  return (to.position - from.position) / (to.time_s - from.time_s);
}

/// Returns the duration of the half step between an edge and a rest, s.
double EdgeTrack::settling_time_s(std::size_t index, double speed) const {
  const double step = 2.0 * std::abs(edges_[index].rest - edges_[index].position);
  const double at_edge = kSpeedAtRestingEdge * std::abs(speed);
  const double longest = kLongestSettling * window_s_;
  return at_edge * longest > step ? step / at_edge : longest;
}

double EdgeTrack::between(std::size_t index, double time_s) const {
  const double arriving_s = settling_time_s(index, index > 0 ? speed_after(index - 1) : 0.0);
  if (index + 1 >= edges_.size()) return arriving(index, time_s);
  const double leaving_s = settling_time_s(index + 1, speed_after(index + 1));
  const double gap = edges_[index + 1].time_s - edges_[index].time_s;
  // A reversal of uniform acceleration lasts up to 1.8 times the sum of the two settling times.
  const bool pause = gap > 2.0 * window_s_ && gap > 2.0 * (arriving_s + leaving_s);
  if (!pause) return parabola(index, time_s);
  const bool early = time_s - edges_[index].time_s < gap / 2.0;
  return early ? arriving(index, time_s) : leaving(index + 1, time_s);
}

double EdgeTrack::arriving(std::size_t index, double time_s) const {
  const AxisEdge& edge = edges_[index];
  const double settling = settling_time_s(index, index > 0 ? speed_after(index - 1) : 0.0);
  const double left = std::max(0.0, 1.0 - (time_s - edge.time_s) / settling);
  return edge.rest + (edge.position - edge.rest) * left * left;
}

double EdgeTrack::leaving(std::size_t index, double time_s) const {
  const AxisEdge& edge = edges_[index];
  const double rest = 2.0 * edge.position - edge.rest;
  const double left =
      std::max(0.0, 1.0 - (edge.time_s - time_s) / settling_time_s(index, speed_after(index)));
  return rest + (edge.position - rest) * left * left;
}

double EdgeTrack::parabola(std::size_t index, double time_s) const {
  const AxisEdge& from = edges_[index];
  const AxisEdge& to = edges_[index + 1];
  const double gap = to.time_s - from.time_s;
  const double speed = speed_after(index);
  double acceleration = 0.0;
  if (index > 0 && index + 2 < edges_.size()) {
    const double apart =
        gap + (edges_[index + 2].time_s - to.time_s + from.time_s - edges_[index - 1].time_s) / 2.0;
    acceleration = (speed_after(index + 1) - speed_after(index - 1)) / apart;
  }
  // The limit keeps the course monotonic between different positions. Between equal positions, it
  // keeps the course within the step.
  const double step = 2.0 * std::abs(from.rest - from.position);
  const double limit = speed == 0.0 ? 8.0 * step / (gap * gap) : 2.0 * std::abs(speed) / gap;
  acceleration = std::clamp(acceleration, -limit, limit);
  const double since = time_s - from.time_s;
  return from.position + speed * since + 0.5 * acceleration * since * (since - gap);
}

}  // namespace sim
