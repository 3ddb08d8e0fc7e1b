#include "tests/support/path_writer.hpp"

#include <algorithm>
#include <cmath>

#include "planner/geometry/arc_fit.hpp"

namespace proof {

cnc::Coordinate PathWriter::on_grid(double mm) const {
  return cnc::Coordinate{
      static_cast<std::int64_t>(std::llround(mm * 1.0e6 / grid_nm_) * std::llround(grid_nm_))};
}

double PathWriter::speed_on(const std::vector<std::size_t>& axes) const {
  double speed = feed_ > 0.0 ? feed_ : 1.0e6;
  for (const std::size_t axis : axes) {
    speed = std::min<double>(speed, cnc::motion::motor_rate(machine_->limits, axis));
  }
  return speed;
}

void PathWriter::element(const Vector& travel, cnc::Plane plane, double bulge) {
  cnc::PathElement element{
      .start = place_, .end = place_, .plane = plane, .bulge = static_cast<float>(bulge)};
  for (std::size_t axis = 0; axis < cnc::kAxisCount; ++axis) {
    element.end[axis] += on_grid(travel[axis]);
  }
  add(element);
}

void PathWriter::circle(const Vector& travel,
                        cnc::Plane plane,
                        const std::array<double, 2>& to_centre,
                        double sweep) {
  const cnc::PlaneAxes axes = cnc::axes_of(plane);
  const cnc::Coordinate i = on_grid(to_centre[0]);
  const cnc::Coordinate j = on_grid(to_centre[1]);
  if (i == cnc::Coordinate{} && j == cnc::Coordinate{}) return;
  cnc::CentreArc arc{.start = place_, .end = place_, .plane = plane};
  for (std::size_t axis = 0; axis < cnc::kAxisCount; ++axis) arc.end[axis] += on_grid(travel[axis]);
  arc.centre = {place_[axes.first] + i, place_[axes.second] + j};
  arc.clockwise = sweep < 0.0;
  const double turns = std::abs(sweep) / 6.283185307179586;
  arc.turns = static_cast<std::uint16_t>(std::max(1.0, std::ceil(turns - 1.0e-9)));
  const double x = -static_cast<double>(i.nanometres()) * 1.0e-6;
  const double y = -static_cast<double>(j.nanometres()) * 1.0e-6;
  arc.end[axes.first] = arc.centre[0] + on_grid(x * std::cos(sweep) - y * std::sin(sweep));
  arc.end[axes.second] = arc.centre[1] + on_grid(x * std::sin(sweep) + y * std::cos(sweep));
  const cnc::ArcElements elements{arc};
  for (std::uint32_t index = 0; index < elements.count(); ++index) add(elements.element(index));
}

void PathWriter::spline(const std::vector<std::array<double, 2>>& points,
                        std::size_t order,
                        float tolerance_mm) {
  cnc::Spline spline;
  spline.set_order(order);
  spline.append({});
  for (const auto& [x, y] : points) {
    spline.append({.place = {on_grid(x).nanometres(), on_grid(y).nanometres()}});
  }
  cnc::ArcFit fit{spline, place_, tolerance_mm};
  while (!fit.done()) add(fit.next());
}

void PathWriter::back_to(const cnc::Position& place) { add({.start = place_, .end = place}); }

void PathWriter::add(const cnc::PathElement& element) {
  items_.push_back({.request = {.element = element,
                                .feed_mm_s = static_cast<float>(feed_),
                                .beam = beam_,
                                .line = static_cast<std::uint32_t>(items_.size() + 1)},
                    .stop_before = stop_});
  stop_ = false;
  account(element);
  place_ = element.end;
}

void PathWriter::account(const cnc::PathElement& element) {
  const ExactBlock block{element};
  if (block.length() <= 0.0) return;
  double speed = feed_ > 0.0 ? feed_ : 1.0e6;
  double acceleration = 1.0e9;
  for (std::size_t axis = 0; axis < cnc::kAxisCount; ++axis) {
    const bool round = block.turns() && block.plane().has(axis);
    const double share = round ? block.plane_share() : std::abs(block.tangent_at(0.0)[axis]);
    if (share <= 0.0) continue;
    const cnc::motion::Limits& limits = machine_->limits;
    speed = std::min(speed, static_cast<double>(cnc::motion::motor_rate(limits, axis)) / share);
    acceleration = std::min(acceleration, double{limits.acceleration_mm_s2[axis]} / share);
    steps_ += share * block.length() * static_cast<double>(limits.scale[axis].steps_per_mm());
  }
  if (block.turns()) speed = std::min(speed, std::sqrt(acceleration * block.radius()));
  seconds_ += block.length() / speed + std::sqrt(block.length() / acceleration);
}

}  // namespace proof
