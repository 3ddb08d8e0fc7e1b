#include "host-sim/surface/probe_grid.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "host-sim/surface/read_surface.hpp"

namespace sim::surface {
namespace {

/// Tolerance, relative to the pitch, by which a span may exceed a whole number of pitches. It
/// allows for rounded decimals.
constexpr double kPitchSlack = 1.0e-6;
/// Minimum pitch, mm. Most machines have longer steps.
constexpr double kMinPitchMm = 0.001;

void require_span(const ProbeSpan& span, char axis, const char* count_name) {
  if (!(std::abs(span.from_mm) <= kFarthestMm && std::abs(span.to_mm) <= kFarthestMm)) {
    throw std::invalid_argument(fmt::format("{}: {:g} to {:g} mm is beyond {:g} mm; check the unit",
                                            axis,
                                            span.from_mm,
                                            span.to_mm,
                                            kFarthestMm));
  }
  if (!(span.from_mm < span.to_mm)) {
    throw std::invalid_argument(
        fmt::format("{}: {:g} to {:g} does not rise; write the smaller coordinate first",
                    axis,
                    span.from_mm,
                    span.to_mm));
  }
  if (span.count < 2) {
    throw std::invalid_argument(
        fmt::format("{}: a grid has at least 2 {}, not {}", axis, count_name, span.count));
  }
  if (span.count <= kMaxProbePoints && span.pitch_mm() < kMinPitchMm) {
    throw std::invalid_argument(
        fmt::format("{}: the points are {:g} mm apart; the minimum is {} mm",
                    axis,
                    span.pitch_mm(),
                    kMinPitchMm));
  }
}

std::size_t nearest_in(const ProbeSpan& span, double coordinate) {
  const double turns = std::round((coordinate - span.from_mm) / span.pitch_mm());
  return static_cast<std::size_t>(std::clamp(turns, 0.0, static_cast<double>(span.count - 1)));
}

}  // namespace

double ProbeSpan::at(std::size_t index) const {
  if (index + 1 == count) return to_mm;
  return from_mm + (to_mm - from_mm) * static_cast<double>(index) / static_cast<double>(count - 1);
}

std::size_t ProbeGrid::driven(std::size_t turn) const {
  const std::size_t row = turn / x.count;
  const std::size_t column = turn % x.count;
  return row * x.count + (row % 2 == 0 ? column : x.count - 1 - column);
}

std::size_t ProbeGrid::nearest(const Eigen::Vector2d& place) const {
  return nearest_in(y, place.y()) * x.count + nearest_in(x, place.x());
}

double ProbeGrid::min_pitch_mm() const { return std::min(x.pitch_mm(), y.pitch_mm()); }

std::string ProbeGrid::name(std::size_t index) const {
  const Eigen::Vector2d at = place(index);
  return fmt::format("row {}, column {} (X {:g}, Y {:g})",
                     index / x.count + 1,
                     index % x.count + 1,
                     at.x(),
                     at.y());
}

ProbeSpan span_of_pitch(double from_mm, double to_mm, double pitch_mm) {
  if (!(pitch_mm >= kMinPitchMm)) {
    throw std::invalid_argument(fmt::format(
        "--pitch: {:g} mm is too small a distance; the minimum is {} mm", pitch_mm, kMinPitchMm));
  }
  const double pitches = std::ceil((to_mm - from_mm) / pitch_mm - kPitchSlack);
  const double most = static_cast<double>(kMaxProbePoints);
  const double count = std::clamp(pitches, 1.0, most) + 1.0;
  return {.from_mm = from_mm, .to_mm = to_mm, .count = static_cast<std::size_t>(count)};
}

void require_probe_grid(const ProbeGrid& grid) {
  require_span(grid.x, 'X', "columns");
  require_span(grid.y, 'Y', "rows");
  if (grid.y.count > kMaxProbePoints / grid.x.count) {
    throw std::invalid_argument(
        fmt::format("{} columns and {} rows are more than {} points; choose a greater pitch",
                    grid.x.count,
                    grid.y.count,
                    kMaxProbePoints));
  }
}

}  // namespace sim::surface
