#include "tests/support/exact_piece.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace proof {

std::array<double, 2> ExactPiece::at(double share) const {
  const double x = x1 - x0;
  const double y = y1 - y0;
  if (bulge == 0.0) return {x0 + share * x, y0 + share * y};
  const double half = 2.0 * std::atan(bulge);
  const double part = std::sin(share * half) / std::sin(half);
  const double turn = (share - 1.0) * half;
  return {x0 + part * (x * std::cos(turn) - y * std::sin(turn)),
          y0 + part * (x * std::sin(turn) + y * std::cos(turn))};
}

double ExactPiece::length() const {
  const double half = 2.0 * std::atan(std::abs(bulge));
  const double chord = std::hypot(x1 - x0, y1 - y0);
  return half > 0.0 ? chord * half / std::sin(half) : chord;
}

double ExactPiece::distance(double x, double y) const {
  const double ends = std::min(std::hypot(x - x0, y - y0), std::hypot(x - x1, y - y1));
  const double dx = x1 - x0;
  const double dy = y1 - y0;
  if (bulge == 0.0) {
    const double along = ((x - x0) * dx + (y - y0) * dy) / (dx * dx + dy * dy);
    if (along <= 0.0 || along >= 1.0) return ends;
    return std::abs((x - x0) * dy - (y - y0) * dx) / std::hypot(dx, dy);
  }
  const double aside = (1.0 - bulge * bulge) / (4.0 * bulge);
  const double cx = x0 + 0.5 * dx - aside * dy;
  const double cy = y0 + 0.5 * dy + aside * dx;
  // The angle from the start in the direction of travel shows whether the point is beside the arc.
  const double turn = bulge > 0.0 ? 1.0 : -1.0;
  const double cross = (x0 - cx) * (y - cy) - (y0 - cy) * (x - cx);
  const double dot = (x0 - cx) * (x - cx) + (y0 - cy) * (y - cy);
  double angle = std::atan2(turn * cross, dot);
  if (angle < 0.0) angle += 8.0 * std::atan(1.0);
  if (angle > 4.0 * std::atan(std::abs(bulge))) return ends;
  return std::abs(std::hypot(x - cx, y - cy) - std::hypot(x0 - cx, y0 - cy));
}

double nearest(const std::vector<ExactPiece>& pieces, double x, double y) {
  double least = 1.0e9;
  for (const ExactPiece& piece : pieces) least = std::min(least, piece.distance(x, y));
  return least;
}

namespace {

/// Returns the least distance between a part of a path and a piece, by the golden section.
double nearest_between(const ExactPiece& way, const ExactPiece& piece, double low, double high) {
  constexpr double kGolden = 0.618033988749895;
  const auto off = [&](double share) {
    const auto [x, y] = way.at(share);
    return piece.distance(x, y);
  };
  double lower = high - kGolden * (high - low);
  double upper = low + kGolden * (high - low);
  double off_lower = off(lower);
  double off_upper = off(upper);
  for (int round = 0; round < 20; ++round) {
    if (off_lower < off_upper) {
      high = std::exchange(upper, lower);
      off_upper = off_lower;
      lower = high - kGolden * (high - low);
      off_lower = off(lower);
    } else {
      low = std::exchange(lower, upper);
      off_lower = off_upper;
      upper = low + kGolden * (high - low);
      off_upper = off(upper);
    }
  }
  return std::min(off_lower, off_upper);
}

/// Returns the least distance between a part of a path and a piece, or `radius` if they come no
/// nearer. Halves the part until it is far enough away, or short enough for a search.
double clearance_between(
    const ExactPiece& way, const ExactPiece& piece, double radius, double low, double high) {
  const double half = 0.5 * (high - low) * way.length();
  const double middle = 0.5 * (low + high);
  const auto [x, y] = way.at(middle);
  const double here = piece.distance(x, y);
  // No point of this part is nearer than `here - half`.
  if (here - half >= radius) return radius;
  if (half > 0.125 * radius + 0.125) {
    return std::min(clearance_between(way, piece, radius, low, middle),
                    clearance_between(way, piece, radius, middle, high));
  }
  double least = std::min(here, nearest_between(way, piece, low, high));
  for (const double end : {low, high}) {
    const auto [end_x, end_y] = way.at(end);
    least = std::min(least, piece.distance(end_x, end_y));
  }
  return least;
}

}  // namespace

double clearance(const ExactPiece& way, const std::vector<ExactPiece>& outline, double radius) {
  double least = radius;
  for (const ExactPiece& piece : outline) {
    least = std::min(least, clearance_between(way, piece, radius, 0.0, 1.0));
  }
  return least;
}

}  // namespace proof
