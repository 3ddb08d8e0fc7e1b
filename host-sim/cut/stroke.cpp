#include "host-sim/cut/stroke.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace sim::cut {
namespace {

/// Least length of a stretch, mm. Shorter stretches are left out.
constexpr double kShortestStretch = 1.0e-6;

double sweep_of(const Stroke& stroke) { return 4.0 * std::atan(stroke.bulge); }

Place left_of(const Place& way) { return {-way.y(), way.x()}; }

Place turned(const Place& way, double angle) {
  return std::cos(angle) * way + std::sin(angle) * left_of(way);
}

/// Returns the centre of an arc.
/// @pre the bulge is not 0
Place centre_of(const Stroke& stroke) {
  const double across = (1.0 - stroke.bulge * stroke.bulge) / (4.0 * stroke.bulge);
  const Place chord = stroke.to - stroke.from;
  return 0.5 * (stroke.from + stroke.to) + across * left_of(chord);
}

double length_of(const Stroke& stroke, const HalfSweep& half) {
  const double chord = drawing::distance(stroke.from, stroke.to);
  return stroke.bulge == 0.0 ? chord : chord * half.angle / half.sine;
}

Place tangent_at(const Stroke& stroke, const HalfSweep& half, double share) {
  const Place chord = stroke.to - stroke.from;
  const Place way = chord / std::hypot(chord.x(), chord.y());
  return half.angle == 0.0 ? way : turned(way, (share - 0.5) * (2.0 * half.angle));
}

}  // namespace

HalfSweep half_sweep_of(const Stroke& stroke) {
  if (stroke.bulge == 0.0) return {};
  const double half = 0.5 * sweep_of(stroke);
  return {half, std::sin(half)};
}

double length_of(const Stroke& stroke) { return length_of(stroke, half_sweep_of(stroke)); }

Place place_at(const Stroke& stroke, double share) {
  return place_at(stroke, half_sweep_of(stroke), share);
}

Place place_at(const Stroke& stroke, const HalfSweep& half, double share) {
  if (share <= 0.0) return stroke.from;
  if (share >= 1.0) return stroke.to;
  // The point is computed relative to the chord, which avoids the distant centre of a flat arc.
  const Place chord = stroke.to - stroke.from;
  if (half.angle == 0.0) return stroke.from + share * chord;
  const double reach = std::sin(share * half.angle) / half.sine;
  return stroke.from + reach * turned(chord, (share - 1.0) * half.angle);
}

Place tangent_at(const Stroke& stroke, double share) {
  return tangent_at(stroke, half_sweep_of(stroke), share);
}

Stroke part_of(const Stroke& stroke, double from, double to) {
  const double bulge = std::tan(0.25 * (to - from) * sweep_of(stroke));
  return {place_at(stroke, from), place_at(stroke, to), bulge, stroke.purpose};
}

Stroke reversed(const Stroke& stroke) {
  Stroke back = stroke;
  back.from = stroke.to;
  back.to = stroke.from;
  back.bulge = -stroke.bulge;
  return back;
}

double distance_to(const Stroke& stroke, const Place& place) {
  const Place chord = stroke.to - stroke.from;
  const Place way = place - stroke.from;
  const double ends =
      std::min(drawing::distance(stroke.from, place), drawing::distance(stroke.to, place));
  if (stroke.bulge == 0.0) {
    const double square = chord.squaredNorm();
    const double share = square > 0.0 ? drawing::dot(way, chord) / square : 0.0;
    if (share <= 0.0 || share >= 1.0) return ends;
    return std::abs(drawing::cross(chord, way)) / std::sqrt(square);
  }
  const Place centre = centre_of(stroke);
  const Place from = stroke.from - centre;
  const Place to = place - centre;
  const double radius = std::hypot(from.x(), from.y());
  const double sweep = sweep_of(stroke);
  double angle = std::atan2(drawing::cross(from, to), drawing::dot(from, to));
  if (sweep < 0.0) angle = -angle;
  if (angle < 0.0) angle += 2.0 * std::numbers::pi;
  if (angle > std::abs(sweep)) return ends;
  return std::abs(std::hypot(to.x(), to.y()) - radius);
}

double length_of(const std::vector<Stroke>& row) {
  double sum = 0.0;
  for (const Stroke& stroke : row) sum += length_of(stroke);
  return sum;
}

MeasuredRow::MeasuredRow(std::vector<Stroke> row) : row_{std::move(row)} {
  halves_.reserve(row_.size());
  ways_.reserve(row_.size() + 1);
  ways_.push_back(0.0);
  for (const Stroke& stroke : row_) {
    halves_.push_back(half_sweep_of(stroke));
    ways_.push_back(ways_.back() + length_of(stroke, halves_.back()));
  }
}

std::vector<Stroke> MeasuredRow::stretch(double from_mm, double to_mm) const {
  std::vector<Stroke> stretch;
  const auto begin = std::upper_bound(ways_.begin() + 1, ways_.end(), from_mm);
  for (auto i = static_cast<std::size_t>(begin - ways_.begin()) - 1; i < row_.size(); ++i) {
    if (ways_[i] >= to_mm) break;
    const double length = ways_[i + 1] - ways_[i];
    const double first = std::max(from_mm - ways_[i], 0.0);
    const double last = std::min(to_mm - ways_[i], length);
    if (last - first < kShortestStretch) continue;
    const double from = first < kShortestStretch ? 0.0 : first / length;
    const double to = length - last < kShortestStretch ? 1.0 : last / length;
    stretch.push_back(from == 0.0 && to == 1.0 ? row_[i] : part_of(row_[i], from, to));
  }
  return stretch;
}

std::vector<Stroke> MeasuredRow::begun_at(double way_mm) const {
  std::vector<Stroke> row = stretch(way_mm, length());
  const std::vector<Stroke> rest = stretch(0.0, way_mm);
  row.insert(row.end(), rest.begin(), rest.end());
  return row;
}

std::size_t MeasuredRow::stroke_at(double way_mm) const {
  const auto next = std::upper_bound(ways_.begin() + 1, ways_.end() - 1, way_mm);
  return static_cast<std::size_t>(next - ways_.begin()) - 1;
}

Place MeasuredRow::place(double way_mm) const {
  const std::size_t i = stroke_at(way_mm);
  return place_at(row_[i], halves_[i], (way_mm - ways_[i]) / (ways_[i + 1] - ways_[i]));
}

Place MeasuredRow::leaving(double way_mm) const {
  const bool around = way_mm + kShortestStretch >= length();
  const std::size_t i = around ? 0 : stroke_at(way_mm + kShortestStretch);
  const double share = around ? 0.0 : (way_mm - ways_[i]) / (ways_[i + 1] - ways_[i]);
  return tangent_at(row_[i], halves_[i], std::clamp(share, 0.0, 1.0));
}

Place MeasuredRow::arriving(double way_mm) const {
  const bool around = way_mm <= kShortestStretch;
  const std::size_t i = around ? row_.size() - 1 : stroke_at(way_mm - kShortestStretch);
  const double share = around ? 1.0 : (way_mm - ways_[i]) / (ways_[i + 1] - ways_[i]);
  return tangent_at(row_[i], halves_[i], std::clamp(share, 0.0, 1.0));
}

}  // namespace sim::cut
