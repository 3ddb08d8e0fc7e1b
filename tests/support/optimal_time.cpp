#include "tests/support/optimal_time.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/support/speed_step.hpp"

namespace sim {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// One sample of the path, with squares of speeds.
struct Node {
  double place = 0.0;
  Point tangent{};
  Point curvature{};
  /// Limit by all rules except that for the acceleration along the path.
  double highest = kInfinity;
  double reachable = 0.0;  ///< Greatest value from which the rest of the path can be driven.
  double speed_squared = 0.0;
};

std::size_t interval_count(const Curve& curve) {
  constexpr double kLongest = 0.02;  // Greatest distance between samples, mm.
  // Greatest angle between samples: half a degree.
  constexpr double kWidest = 0.5 * std::numbers::pi / 180.0;
  const double sweep = curve.circle() ? std::abs(curve.circle()->sweep) : 0.0;
  const double even = std::max(curve.length() / kLongest, sweep / kWidest);
  return static_cast<std::size_t>(
      std::clamp(std::ceil(even * std::numbers::pi / 2.0), 8.0, 4000.0));
}

/// Returns the fraction of a sample. Samples are closest at both ends, where the speed may change
/// most; in the middle their spacing is π/2 times the even one.
double node_fraction(std::size_t index, std::size_t count) {
  if (index == count) return 1.0;
  const double part = static_cast<double>(index) / static_cast<double>(count);
  return (1.0 - std::cos(std::numbers::pi * part)) / 2.0;
}

void add_nodes(std::vector<Node>& nodes, const PathPiece& piece, const MotionLimits& limits) {
  const double start = nodes.empty() ? 0.0 : nodes.back().place;
  const std::size_t count = interval_count(piece.curve);
  for (std::size_t i = 0; i <= count; ++i) {
    const double fraction = node_fraction(i, count);
    Node node{.place = start + fraction * piece.curve.length(),
              .tangent = piece.curve.tangent_at(fraction),
              .curvature = piece.curve.curvature_at(fraction)};
    node.highest = speed_limit_squared(piece, node.tangent, node.curvature, limits);
    nodes.push_back(node);
  }
}

std::vector<Node> nodes_of(const ProgrammedPath& path, const MotionLimits& limits) {
  std::vector<Node> nodes;
  for (const PathPiece& piece : path.pieces) {
    const std::size_t joint = nodes.size();
    add_nodes(nodes, piece, limits);
    if (joint == 0) continue;
    if (is_stop(piece, nodes[joint - 1].tangent, nodes[joint].tangent)) {
      nodes[joint].highest = 0.0;
    }
  }
  return nodes;
}

SpeedStep step_between(const Node& from, const Node& to, const MotionLimits& limits) {
  return {to.place - from.place,
          {from.tangent, from.curvature},
          {to.tangent, to.curvature},
          limits.acceleration};
}

bool is_joint(const Node& from, const Node& to) { return from.place == to.place; }

void go_backward(std::vector<Node>& nodes, const MotionLimits& limits) {
  nodes.back().reachable = 0.0;
  for (std::size_t i = nodes.size() - 1; i-- > 0;) {
    Node& from = nodes[i];
    const Node& to = nodes[i + 1];
    from.reachable =
        is_joint(from, to)
            ? std::min(from.highest, to.reachable)
            : step_between(from, to, limits).greatest_start(to.reachable, from.highest);
  }
}

void go_forward(std::vector<Node>& nodes, const MotionLimits& limits) {
  nodes.front().speed_squared = 0.0;
  for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
    const Node& from = nodes[i];
    Node& to = nodes[i + 1];
    to.speed_squared =
        is_joint(from, to)
            ? from.speed_squared
            : step_between(from, to, limits).greatest_end(from.speed_squared, to.reachable);
  }
}

}  // namespace

bool is_stop(const PathPiece& piece, const Point& leaving, const Point& entering) {
  // Radians. Rounding of points to a nanometre turns a smooth joint of blends that are some ten
  // nanometres long by less.
  constexpr double kGreatestTurn = 0.3;
  return piece.stop_before || norm(entering - leaving) > kGreatestTurn;
}

double speed_limit_squared(const PathPiece& piece,
                           const Point& tangent,
                           const Point& curvature,
                           const MotionLimits& limits) {
  double speed = piece.path_feed();
  double steps = 0.0;
  for (std::size_t i = 0; i < tangent.size(); ++i) {
    const double share = std::abs(tangent[i]);
    if (share > 0.0) speed = std::min(speed, limits.rate[i] / share);
    steps += share * limits.steps_per_mm[i];
  }
  if (steps > 0.0) speed = std::min(speed, limits.step_rate / steps);
  double highest = speed * speed;
  for (std::size_t i = 0; i < curvature.size(); ++i) {
    const double bend = std::abs(curvature[i]);
    if (limits.acceleration[i] < highest * bend) highest = limits.acceleration[i] / bend;
  }
  return highest;
}

double SpeedProfile::seconds() const {
  double sum = 0.0;
  for (std::size_t i = 0; i + 1 < samples.size(); ++i) {
    const double length = samples[i + 1].place - samples[i].place;
    if (length > 0.0) sum += 2.0 * length / (samples[i].speed + samples[i + 1].speed);
  }
  return sum;
}

SpeedProfile optimal_profile(const ProgrammedPath& path, const MotionLimits& limits) {
  SpeedProfile profile;
  if (path.pieces.empty()) return profile;
  std::vector<Node> nodes = nodes_of(path, limits);
  go_backward(nodes, limits);
  nodes.front().reachable = 0.0;
  go_forward(nodes, limits);
  for (const Node& node : nodes) {
    profile.samples.push_back(
        {node.place, std::sqrt(node.speed_squared), node.tangent, node.curvature});
  }
  return profile;
}

double optimal_time(const ProgrammedPath& path, const MotionLimits& limits) {
  return optimal_profile(path, limits).seconds();
}

}  // namespace sim
