#include "host-sim/measure/shaping_meter.hpp"

#include <algorithm>
#include <cmath>

namespace sim {
namespace {

/// Returns the distance from `point` to the straight line between two other points.
double distance_to_chord(const Point& point, const Point& from, const Point& to) {
  double along = 0.0;
  double square = 0.0;
  for (std::size_t i = 0; i < point.size(); ++i) {
    along += (point[i] - from[i]) * (to[i] - from[i]);
    square += (to[i] - from[i]) * (to[i] - from[i]);
  }
  const double share = square > 0.0 ? std::clamp(along / square, 0.0, 1.0) : 0.0;
  double sum = 0.0;
  for (std::size_t i = 0; i < point.size(); ++i) {
    const double off = point[i] - from[i] - share * (to[i] - from[i]);
    sum += off * off;
  }
  return std::sqrt(sum);
}

}  // namespace

Point ShapingMeter::to_mm(const cnc::AxisArray<cnc::StepPosition>& places) const {
  Point mm{};
  for (std::size_t axis = 0; axis < mm.size(); ++axis) {
    mm[axis] = static_cast<double>(places[axis].q32()) * 0x1.0p-32 / steps_per_mm_[axis];
  }
  return mm;
}

void ShapingMeter::on_cell(const cnc::motion::ShapedCell& cell) {
  planned_.push_front(to_mm(cell.planned));
  while (planned_.size() > cell.reach + 1U) planned_.pop_back();
  const Point shaped = to_mm(cell.shaped);
  double least = distance_to_chord(shaped, planned_.front(), planned_.front());
  for (std::size_t i = 1; i < planned_.size(); ++i) {
    least = std::min(least, distance_to_chord(shaped, planned_[i - 1], planned_[i]));
  }
  greatest_ = std::max(greatest_, least);
}

}  // namespace sim
