#include "tests/support/random_program.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "planner/geometry/arc_fit.hpp"
#include "tests/support/path_writer.hpp"

namespace proof {
namespace {

/// Writes stretches of a program, each of one kind.
class Author {
 public:
  Author(Random& random, const TestMachine& machine, const ProgramSize& size)
      : random_{random},
        writer_{machine, std::pow(10.0, -static_cast<double>(2 + random.below(5)))},
        seconds_{random.magnitude(size.min_time_s, size.max_time_s)},
        steps_{random.magnitude(size.max_steps * 0.01, size.max_steps)},
        kinds_{size.splines ? kSpline + 1 : kSpline} {
    choose_axes();
  }

  std::vector<ProgramItem> write() {
    for (int stretch = 0; stretch < 40 && !enough(); ++stretch) write_stretch();
    return writer_.take();
  }

 private:
  [[nodiscard]] bool enough() const {
    return writer_.seconds() > seconds_ || writer_.steps() > steps_;
  }

  void choose_axes() {
    while (axes_.size() < 2) {
      axes_.clear();
      for (std::size_t axis = 0; axis < cnc::kAxisCount; ++axis) {
        if (random_.chance(axis < 3 ? 0.7 : 0.25)) axes_.push_back(axis);
      }
    }
  }

  void write_stretch() {
    set_up();
    const std::size_t kind = random_.below(kinds_);
    const std::size_t count = 1 + random_.below(kind == 1 || kind == 5 ? 80 : 12);
    for (std::size_t i = 0; i < count && !enough(); ++i) write_element(kind);
  }

  /// Chooses feed (1…60000 mm/min or rapid), beam and size for a stretch.
  void set_up() {
    writer_.set_feed(random_.chance(0.2) ? 0.0 : random_.magnitude(1.0, 60'000.0) / 60.0);
    writer_.set_beam(
        {.duty = static_cast<float>(random_.unit()), .follows_speed = random_.chance(0.5)});
    if (random_.chance(0.15)) writer_.stop();
    const double reach = std::max(0.002, writer_.speed_on(axes_) * seconds_ * 0.5);
    scale_ = random_.magnitude(0.001, reach);
    turn_ = random_.signed_magnitude(1.0e-6, 0.2);
    heading_ = random_.between(-std::numbers::pi, std::numbers::pi);
    plane_ = static_cast<cnc::Plane>(random_.below(3));
  }

  void write_element(std::size_t kind) {
    switch (kind) {
      case 0:
        return writer_.line(anywhere(random_.magnitude(scale_ * 0.01, scale_)));
      case 1:
        return writer_.line(anywhere(random_.between(0.0005, 0.003)));
      case 2:
        return there_and_back();
      case 3:
        return almost_straight_on();
      case 4:
        return steep();
      case 5:
        return polyline_of_a_curve();
      case 6:
        return tangent_arc();
      case 7:
        return full_circle();
      case 8:
        return writer_.line({});
      case 9:
        return along_an_axis();
      case kSpline:
        return spline();
      default:
        return any_arc();
    }
  }

  Vector anywhere(double length) {
    Vector direction{};
    double square = 0.0;
    while (square < 1.0e-4 || square > 1.0) {
      square = 0.0;
      for (const std::size_t axis : axes_) {
        direction[axis] = random_.between(-1.0, 1.0);
        square += direction[axis] * direction[axis];
      }
      // With many axes, rejection takes too long, and an uneven distribution is acceptable.
      if (axes_.size() > 4) break;
    }
    for (double& share : direction) share *= length / std::sqrt(square);
    return direction;
  }

  Vector in_plane(double length, double angle) const {
    Vector travel{};
    travel[cnc::axes_of(plane_).first] = length * std::cos(angle);
    travel[cnc::axes_of(plane_).second] = length * std::sin(angle);
    return travel;
  }

  void there_and_back() {
    const cnc::Position from = writer_.place();
    writer_.line(anywhere(scale_));
    writer_.back_to(from);
  }

  void almost_straight_on() {
    heading_ += random_.chance(0.5) ? turn_ : -turn_;
    writer_.line(in_plane(random_.between(0.1, 1.0) * scale_, heading_));
  }

  void steep() {
    Vector travel = anywhere(scale_);
    travel[axes_[random_.below(axes_.size())]] *= 1.0e4 * random_.unit();
    const double size = norm(travel);
    for (double& share : travel) share *= scale_ / size;
    writer_.line(travel);
  }

  void polyline_of_a_curve() {
    heading_ += turn_ * random_.between(0.8, 1.2);
    writer_.line(in_plane(std::min(scale_, random_.between(0.05, 0.2)), heading_));
  }

  /// Writes an arc that begins in the direction in which the last element ended.
  void tangent_arc() {
    const double half = random_.signed_magnitude(1.0e-5, 0.5 * std::numbers::pi);
    writer_.arc(in_plane(scale_ * random_.between(0.2, 1.0), heading_ + half),
                plane_,
                std::tan(half / 2.0));
    heading_ += 2.0 * half;
  }

  void full_circle() {
    Vector pitch{};
    if (random_.chance(0.5)) pitch = anywhere(scale_ * random_.unit());
    const double radius = scale_ * random_.between(0.02, 0.3);
    const double angle = random_.between(-std::numbers::pi, std::numbers::pi);
    const double sweep = (1.0 + static_cast<double>(random_.below(3))) * 2.0 * std::numbers::pi;
    writer_.circle(pitch,
                   plane_,
                   {radius * std::cos(angle), radius * std::sin(angle)},
                   random_.chance(0.5) ? sweep : -sweep);
  }

  void any_arc() {
    Vector travel = in_plane(scale_, random_.between(-std::numbers::pi, std::numbers::pi));
    if (random_.chance(0.4)) {
      const Vector more = anywhere(random_.magnitude(scale_ * 1.0e-4, scale_));
      for (std::size_t axis = 0; axis < more.size(); ++axis) travel[axis] += more[axis];
    }
    const double bulge = random_.chance(0.2) ? 1.0 : random_.magnitude(1.0e-6, 1.0);
    writer_.arc(travel, plane_, random_.chance(0.5) ? bulge : -bulge);
  }

  /// Writes a spline as by G5, G5.1 and G5.2, but without weights, which hardly affect curves of
  /// few points.
  void spline() {
    const std::size_t order = 3 + random_.below(2);
    const std::size_t count = order + random_.below(5);
    std::vector<std::array<double, 2>> points;
    const double size = std::min(scale_, 0.4 * double{cnc::ArcFit::kLargestSplineMm});
    for (std::size_t i = 1; i < count; ++i) {
      points.push_back({random_.between(-size, size), random_.between(-size, size)});
    }
    writer_.spline(points, order, static_cast<float>(random_.magnitude(5.0e-4, 0.02)));
  }

  void along_an_axis() {
    Vector travel{};
    travel[axes_[random_.below(axes_.size())]] = random_.chance(0.5) ? scale_ : -scale_;
    writer_.line(travel);
  }

  /// Programs contain all kinds before this one even without `splines`.
  static constexpr std::size_t kSpline = 11;

  Random& random_;
  PathWriter writer_;
  double seconds_;
  double steps_;
  std::size_t kinds_;
  std::vector<std::size_t> axes_{};
  double scale_ = 1.0;    ///< Size of the elements, mm.
  double turn_ = 0.0;     ///< Angle from one element to the next, radians.
  double heading_ = 0.0;  ///< Direction of the tangent in the plane, radians.
  cnc::Plane plane_ = cnc::Plane::kXY;
};

}  // namespace

Program random_program(Random& random, const TestMachine& machine, const ProgramSize& size) {
  Program program;
  program.items = Author{random, machine, size}.write();
  if (random.chance(0.5)) {
    program.pushed_at_once = 1 + random.below(6);
    program.cut_at_once = 1 + random.below(30);
  }
  return program;
}

}  // namespace proof
