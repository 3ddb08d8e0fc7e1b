#include "host-sim/contour/known_rows.hpp"

#include <cmath>
#include <variant>

#include "planner/base/contract.hpp"

namespace sim {
namespace {

using drawing::Bezier;
using drawing::Place;

// Units per mm: 2^34, so that the division by this number is exact.
constexpr double kUnitsPerMm = 17'179'869'184.0;
constexpr double kLongestMm = 1.0e6;

}  // namespace

std::optional<RowShape> RowShape::of(std::span<const drawing::Shape> row) {
  CNC_ASSERT(!row.empty());
  if (row.size() > kMaxCurves) return std::nullopt;
  RowShape shape;
  shape.curves_ = row.size();
  shape.numbers_.reserve(6 * row.size() + 4);
  const Place start = drawing::start_of(row.front());
  Place end = start;
  for (const drawing::Shape& each : row) {
    const auto* const curve = std::get_if<Bezier>(&each);
    if (curve == nullptr || curve->points.front() != end) return std::nullopt;
    end = curve->points.back();
    for (std::size_t i = 1; i < curve->points.size(); ++i) {
      const Place seen = curve->points[i] - start;
      if (!(seen.cwiseAbs().maxCoeff() < kLongestMm)) return std::nullopt;
      shape.add(std::llround(kUnitsPerMm * seen.x()));
      shape.add(std::llround(kUnitsPerMm * seen.y()));
    }
  }
  return shape;
}

std::vector<drawing::Shape> RowShape::curves() const {
  std::vector<drawing::Shape> curves;
  curves.reserve(curves_);
  Place from{0.0, 0.0};
  const auto place = [&](std::size_t number) {
    return Place{static_cast<double>(numbers_[number]) / kUnitsPerMm,
                 static_cast<double>(numbers_[number + 1]) / kUnitsPerMm};
  };
  for (std::size_t i = 0; i < curves_; ++i) {
    const Bezier curve{{from, place(6 * i), place(6 * i + 2), place(6 * i + 4)}};
    from = curve.points[3];
    curves.emplace_back(curve);
  }
  return curves;
}

}  // namespace sim
