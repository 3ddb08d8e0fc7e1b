#include "host-sim/joints/joint_way.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <stdexcept>

namespace sim::joints {
namespace {

constexpr std::size_t kMaxMoves = 1'000'000;
/// Fractions of a move at which the tip's error is measured. The error is 0 at the ends of a move
/// and greatest near its middle.
constexpr std::array<double, 3> kLooked{0.25, 0.5, 0.75};

Point between(const Point& from, const Point& to, double share) {
  Point place{};
  for (std::size_t axis = 0; axis < place.size(); ++axis) {
    place[axis] = from[axis] + share * (to[axis] - from[axis]);
  }
  return place;
}

double tip_distance(const Point& a, const Point& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

JointWay way_of(const FiveAxisModel& model, const Curve& curve, std::size_t count) {
  JointWay way;
  way.ends.reserve(count);
  Point from = model.axes_for(curve.start());
  for (std::size_t i = 0; i < count; ++i) {
    const auto fraction = [&](double share) {
      return (static_cast<double>(i) + share) / static_cast<double>(count);
    };
    const Point to = model.axes_for(curve.point_at(fraction(1.0)));
    for (const double share : kLooked) {
      const Point tip = model.program_for(between(from, to, share));
      way.error_mm = std::max(way.error_mm, tip_distance(tip, curve.point_at(fraction(share))));
    }
    way.ends.push_back(to);
    from = to;
  }
  return way;
}

}  // namespace

JointWay joint_way(const FiveAxisModel& model, const Curve& curve, double tolerance_mm) {
  std::size_t count = 1;
  while (true) {
    JointWay way = way_of(model, curve, count);
    if (way.error_mm <= tolerance_mm) return way;
    // The error is inversely proportional to the square of the number of moves.
    const double wanted = static_cast<double>(count) * std::sqrt(way.error_mm / tolerance_mm);
    if (!(wanted < static_cast<double>(kMaxMoves))) {
      throw std::invalid_argument(
          fmt::format("a motion needs more than {} moves to keep the tip within {} mm; divide the "
                      "motion, or increase --tip-tolerance",
                      kMaxMoves,
                      tolerance_mm));
    }
    count = std::max(count + 1, static_cast<std::size_t>(std::ceil(wanted)));
  }
}

}  // namespace sim::joints
