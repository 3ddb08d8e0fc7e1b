#include <cmath>

#include "host-sim/measure/program_reader.hpp"

namespace sim {
namespace {

std::array<double, 2> place_of(const Point& point) { return {point[0], point[1]}; }

std::array<double, 2> sum(const std::array<double, 2>& a, const std::array<double, 2>& b) {
  return {a[0] + b[0], a[1] + b[1]};
}

}  // namespace

void ProgramReader::move_cubic(const ProgramLine& line, const Point& to) {
  const auto arm = [&](char letter) { return modes_.scaled(0, line.value(letter).value_or(0.0)); };
  std::array<double, 2> first{-last_arm_[0], -last_arm_[1]};
  if (line.value('I')) first = {arm('I'), arm('J')};
  last_arm_ = {arm('P'), arm('Q')};
  const auto start = place_of(position_);
  const auto end = place_of(to);
  move_along({.start = position_,
              .points = {start, sum(start, first), sum(end, last_arm_), end},
              .weights = {1.0, 1.0, 1.0, 1.0},
              .order = 4});
}

void ProgramReader::move_quadratic(const ProgramLine& line, const Point& to) {
  const auto arm = [&](char letter) { return modes_.scaled(0, line.value(letter).value_or(0.0)); };
  const auto start = place_of(position_);
  move_along({.start = position_,
              .points = {start, sum(start, {arm('I'), arm('J')}), place_of(to)},
              .weights = {1.0, 1.0, 1.0},
              .order = 3});
}

void ProgramReader::take_control_point(const ProgramLine& line, const Point& to) {
  const double weight = line.value('P').value_or(1.0);
  if (!nurbs_) {
    nurbs_ = ProgrammedSpline{
        .start = position_, .points = {place_of(position_)}, .weights = {1.0}, .order = 3};
  }
  if (const auto order = line.value('L')) nurbs_->order = static_cast<std::size_t>(*order);
  if (!line.has_axis_words()) {
    if (line.value('P')) nurbs_->weights.front() = weight;
    return;
  }
  nurbs_->points.push_back(place_of(to));
  nurbs_->weights.push_back(weight);
}

void ProgramReader::end_nurbs() {
  modes_.end_nurbs();
  if (!nurbs_ || !nurbs_->complete()) return note("the NURBS has too few control points; left out");
  move_along(*nurbs_);
  nurbs_.reset();
}

void ProgramReader::move_along(const ProgrammedSpline& spline) {
  const std::vector<Curve> pieces = pieces_of(spline);
  double length = 0.0;
  for (const Curve& piece : pieces) length += piece.linear_length();
  const double feed = modes_.feed(length, 0.0);
  spline_tolerance_ = modes_.spline_tolerance(options_.arc_tolerance);
  for (const Curve& piece : pieces) add_piece(piece, Travel::kFeed, feed);
  spline_tolerance_ = 0.0;
  path_.end = position_ = spline.end();
}

}  // namespace sim
