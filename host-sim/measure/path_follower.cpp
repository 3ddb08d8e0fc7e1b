#include "host-sim/measure/path_follower.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace sim {
namespace {

/// Distance beyond the smallest distance so far at which the search ahead ends, in step diagonals.
/// The tolerance by which corners or tips of curves may be cut is added to this value. It exceeds
/// the two steps by which the place may trail.
constexpr double kWindowSteps = 3.0;

/// Distance beyond that of the nearest point up to which another point counts as equally near, in
/// step diagonals. It is slightly more than half a diagonal, by which the motors of an ideal
/// machine are off.
constexpr double kTieSteps = 0.55;

/// Distance by which the place stays before the nearest point of its piece, in step diagonals.
constexpr double kTrailSteps = 1.0;

double moved_step_diagonal(const ProgrammedPath& path, const Point& step) {
  const Bounds bounds = path.bounds();
  double sum = 0.0;
  for (std::size_t i = 0; i < step.size(); ++i) {
    if (bounds.high[i] > bounds.low[i]) sum += step[i] * step[i];
  }
  return std::sqrt(sum);
}

}  // namespace

PathFollower::PathFollower(const ProgrammedPath& path, const Point& step)
    : path_{&path}, step_{step}, step_size_{moved_step_diagonal(path, step)} {}

PathFollower::Match PathFollower::advance(const Point& position) {
  if (path_->pieces.empty()) {
    return {0, {0.0, distance(position, path_->start), path_->start}};
  }
  const Match best = look_ahead(position);
  for (const Match& match : window_) {
    const double near = best.nearest.distance + kTieSteps * step_size_ + arcs_of(match.piece);
    if (match.nearest.distance > near) continue;
    move_to(match, position, near);
    break;
  }
  return best;
}

PathFollower::Match PathFollower::look_ahead(const Point& position) {
  Match best{0, {0.0, std::numeric_limits<double>::infinity(), {}}};
  window_.clear();
  double to_start = 0.0;
  for (std::size_t index = piece_; index < path_->pieces.size(); ++index) {
    const double to_end = distance(position, curve(index).end());
    const double at_least = std::max(to_start, to_end) - curve(index).length();
    if (at_least <= best.nearest.distance + kTieSteps * step_size_) {
      window_.push_back({index, curve(index).nearest(position, from(index))});
      if (window_.back().nearest.distance < best.nearest.distance) best = window_.back();
    }
    // The place may still be before the tip of a bend that the machine has already passed.
    const bool trails = index <= latest_ && arcs_of(piece_) > 0.0;
    if (!trails && to_end > best.nearest.distance + window(index)) break;
    to_start = to_end;
  }
  latest_ = std::max(latest_, best.piece);
  return best;
}

double PathFollower::window(std::size_t index) const {
  const ProgramTolerance& allowed = path_->pieces[index].tolerance;
  return kWindowSteps * step_size_ + allowed.corner + allowed.weld + allowed.spline +
         allowed.motors;
}

void PathFollower::move_to(const Match& match, const Point& position, double near) {
  if (arcs_of(match.piece) > 0.0) {
    fraction_ = earliest_near(match, position, near);
  } else {
    const double trail = kTrailSteps * step_size_ / curve(match.piece).length();
    fraction_ = std::max(match.nearest.fraction - trail, from(match.piece));
  }
  piece_ = match.piece;
}

/// Returns the earliest point of a curve that is within `near` of the position. The arcs that
/// replace a curve may be nearer to the leg after the tip of a narrow bend than to the leg before
/// it. The tip must stay ahead of the place.
double PathFollower::earliest_near(const Match& match, const Point& position, double near) const {
  constexpr double kStride = 0.25;
  const Curve& curve = this->curve(match.piece);
  const double stride = kStride * near / curve.length();
  double fraction = from(match.piece);
  while (fraction < match.nearest.fraction && distance(position, curve.point_at(fraction)) > near) {
    fraction += stride;
  }
  return std::min(fraction, match.nearest.fraction);
}

double PathFollower::excess_at(const Point& position, const Point& place) const {
  double greatest = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < position.size(); ++i) {
    greatest = std::max(greatest, std::abs(position[i] - place[i]) - step_[i] / 2.0);
  }
  return greatest;
}

double PathFollower::excess_between(
    const Point& position, const Curve& curve, double low, double high, double enough) const {
  constexpr int kThirds = 24;  // The result is exact to 6e-5 of half a step.
  double least = excess_at(position, curve.point_at((low + high) / 2.0));
  for (int i = 0; i < kThirds && least > enough; ++i) {
    const double third = (high - low) / 3.0;
    const double left = excess_at(position, curve.point_at(low + third));
    const double right = excess_at(position, curve.point_at(high - third));
    (left < right ? high : low) = left < right ? high - third : low + third;
    least = std::min({least, left, right});
  }
  return least;
}

// Returns the excess on one piece. Along a line, the excess is convex. Where an arc just touches
// the edge of a step, the excess has more than one minimum. Therefore the search is done in parts.
double PathFollower::piece_excess(const Point& position, const Match& match, double enough) const {
  // The four steps around the nearest point are divided into eight parts. They are searched in this
  // order, from the nearest point outwards. A point with an excess of at most `enough` is likely to
  // be near it.
  constexpr std::array kParts{3, 4, 2, 5, 1, 6, 0, 7};
  const Curve& curve = this->curve(match.piece);
  const double reach = 2.0 * step_size_ / curve.length();
  const double low = std::max(from(match.piece), match.nearest.fraction - reach);
  const double part = (std::min(1.0, match.nearest.fraction + reach) - low) / kParts.size();
  double least = excess_at(position, match.nearest.point);
  for (const int i : kParts) {
    if (least <= enough) break;
    const double from = low + part * i;
    least = std::min(least, excess_between(position, curve, from, from + part, enough));
  }
  return least;
}

double PathFollower::axis_excess(const Point& position, double enough) const {
  if (path_->pieces.empty()) return excess_at(position, path_->start);
  double least = std::numeric_limits<double>::infinity();
  for (const Match& match : window_) {
    if (match.piece < piece_) continue;
    least = std::min(least, piece_excess(position, match, enough));
    if (least <= enough) break;
  }
  return least;
}

}  // namespace sim
