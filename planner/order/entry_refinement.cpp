#include "planner/order/entry_refinement.hpp"

#include <algorithm>
#include <cmath>

namespace cnc::order {
namespace {

double way(const Place& from, const Place& by, const Place& to) {
  return std::sqrt(squared_distance(from, by)) + std::sqrt(squared_distance(by, to));
}

/// The reflection of one place in the line makes the shortest path straight: it crosses the line at
/// the two places' distances from it, in proportion.
double best_on_line(const EntryPiece& line, const Place& from, const Place& to) {
  const double dx = line.end.x - line.start.x;
  const double dy = line.end.y - line.start.y;
  const double squared = dx * dx + dy * dy;
  if (squared == 0.0) return line.first;
  const auto along = [&](const Place& place) {
    return ((place.x - line.start.x) * dx + (place.y - line.start.y) * dy) / squared;
  };
  const auto aside = [&](const Place& place) {
    return std::abs((place.y - line.start.y) * dx - (place.x - line.start.x) * dy);
  };
  const double both = aside(from) + aside(to);
  // With both on the line every parameter between them is as good.
  const double share = both > 0.0 ? aside(from) / both : 0.5;
  const double parameter = along(from) + share * (along(to) - along(from));
  return std::clamp(parameter, line.first, line.last);
}

double best_on_arc(const EntryPiece& arc, const Place& from, const Place& to) {
  constexpr int kSamples = 32;
  constexpr int kThirds = 60;
  const auto cost = [&](double parameter) { return way(from, arc.at(parameter), to); };
  const auto sample = [&](int i) {
    return i >= kSamples ? arc.last : arc.first + i * ((arc.last - arc.first) / kSamples);
  };
  // By thirds around each sample that is better than its neighbours.
  const auto refined = [&](double low, double high) {
    for (int i = 0; i < kThirds; ++i) {
      const double third = (high - low) / 3.0;
      if (cost(low + third) <= cost(high - third)) {
        high -= third;
      } else {
        low += third;
      }
    }
    return 0.5 * (low + high);
  };
  double best = cost(arc.first) <= cost(arc.last) ? arc.first : arc.last;
  for (int i = 0; i <= kSamples; ++i) {
    const double low = sample(std::max(i - 1, 0));
    const double high = sample(i + 1);
    if (cost(sample(i)) > std::min(cost(low), cost(high))) continue;
    const double parameter = refined(low, high);
    if (cost(parameter) < cost(best)) best = parameter;
  }
  return best;
}

/// Puts a point to the best place of its contour. @return the gain, 0 where none is better
double improve(PiercePoint& point, const Place& from, const Place& to) {
  const double present = way(from, point.place(), to);
  double least = present;
  for (Index i = 0; i < point.pieces.size(); ++i) {
    const double parameter = best_parameter(point.pieces[i], from, to);
    const double length = way(from, point.pieces[i].at(parameter), to);
    if (length >= least) continue;
    least = length;
    point.piece = i;
    point.parameter = parameter;
  }
  return present - least;
}

}  // namespace

Place EntryPiece::at(double parameter) const {
  const double t = parameter;
  const double u = 1.0 - t;
  if (bulge == 0.0) return {u * start.x + t * end.x, u * start.y + t * end.y};
  // The weighted middle control point stays finite for half a turn, where its weight is 0.
  const double scale = 1.0 / (1.0 + bulge * bulge);
  const double weight = (1.0 - bulge * bulge) * scale;
  const double sine = 2.0 * bulge * scale;
  const double middle_x = 0.5 * (weight * (start.x + end.x) + sine * (end.y - start.y));
  const double middle_y = 0.5 * (weight * (start.y + end.y) - sine * (end.x - start.x));
  const double below = u * u + 2.0 * u * t * weight + t * t;
  return {(u * u * start.x + 2.0 * u * t * middle_x + t * t * end.x) / below,
          (u * u * start.y + 2.0 * u * t * middle_y + t * t * end.y) / below};
}

double best_parameter(const EntryPiece& piece, const Place& from, const Place& to) {
  return piece.bulge == 0.0 ? best_on_line(piece, from, to) : best_on_arc(piece, from, to);
}

double refine_pierce_points(std::span<PiercePoint> points,
                            const Place& start,
                            const Place& end,
                            double least_gain,
                            int rounds) {
  double sum = 0.0;
  for (int round = 0; round < rounds; ++round) {
    double gain = 0.0;
    Place before = start;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Place behind = i + 1 < points.size() ? points[i + 1].place() : end;
      gain += improve(points[i], before, behind);
      before = points[i].place();
    }
    sum += gain;
    if (gain <= least_gain) break;
  }
  return sum;
}

}  // namespace cnc::order
