#pragma once

#include <optional>

#include "planner/kerf/kerf_lookup.hpp"

namespace cnc::kerf {
namespace detail {

constexpr bool rises(std::uint32_t before, std::uint32_t here, std::uint32_t most) {
  return here > before && here <= most;
}

constexpr bool are_sound_points(const Band& band, std::span<const Point> points) {
  if (points.empty()) return false;
  if (points.front().speed_um_min != band.min_um_min) return false;
  if (points.back().speed_um_min != band.max_um_min) return false;
  for (std::size_t i = 1; i < points.size(); ++i) {
    if (points[i].speed_um_min <= points[i - 1].speed_um_min) return false;
  }
  return true;
}

/// Returns whether a kerf is within its range. The result is false for NaN.
template <typename Real>
constexpr bool is_sound_kerf(Real kerf_mm) {
  return kerf_mm > Real{0} && kerf_mm <= static_cast<Real>(kMaxKerfNm) / Real{1'000'000};
}

/// Returns whether the kerf of a band is in range. The law is monotonic in the speed, and points
/// are joined by lines, so a check at both ends and at the points suffices.
template <typename Real>
constexpr bool has_sound_kerf(const TableView<Real>& table,
                              const Row<Real>& row,
                              const Band& band) {
  for (const Point& point : table.points_of(band)) {
    if (point.kerf_nm == 0 || point.kerf_nm > kMaxKerfNm) return false;
  }
  constexpr auto kMax = static_cast<Real>(kMaxInterceptMm);
  if (!(row.law.intercept >= -kMax && row.law.intercept <= kMax)) return false;
  return is_sound_kerf(row_kerf(table, row, band.power_mw, band.min_um_min)) &&
         is_sound_kerf(row_kerf(table, row, band.power_mw, band.max_um_min));
}

template <typename Real>
constexpr std::optional<TableError> fault_of_band(const TableView<Real>& table,
                                                  const Row<Real>& row,
                                                  const Band& band) {
  if (band.min_um_min < kMinSpeedUmMin || band.max_um_min > kMaxSpeedUmMin ||
      band.min_um_min > band.max_um_min) {
    return TableError::kBadSpeeds;
  }
  const auto points = table.points_of(band);
  if (row.measured ? !are_sound_points(band, points) : !points.empty()) {
    return TableError::kBadPoints;
  }
  if (!has_sound_kerf(table, row, band)) return TableError::kBadKerf;
  return std::nullopt;
}

template <typename Real>
constexpr std::optional<TableError> fault_of_row(const TableView<Real>& table,
                                                 const Row<Real>& row) {
  std::uint32_t power_before = 0;
  for (const Band& band : table.bands_of(row)) {
    if (!rises(power_before, band.power_mw, kMaxPowerMw)) return TableError::kPowerNotRising;
    power_before = band.power_mw;
    if (const auto fault = fault_of_band(table, row, band)) return fault;
  }
  return std::nullopt;
}

/// Returns whether the rows contain all bands in order, and the bands contain all points in order.
template <typename Real>
constexpr bool is_in_order(const TableView<Real>& table) {
  std::size_t bands = 0;
  for (const Row<Real>& row : table.rows) {
    if (row.first_band != bands || row.bands == 0) return false;
    bands += row.bands;
  }
  std::size_t points = 0;
  for (const Band& band : table.bands) {
    if (band.first_point != points) return false;
    points += band.points;
  }
  return bands == table.bands.size() && points == table.points.size();
}

}  // namespace detail

/// Returns the first fault of a table, or nothing if the table is sound: usable for lookups. Checks
/// everything on which lookups rely, so the memory may contain arbitrary values.
template <typename Real>
[[nodiscard]] constexpr std::optional<TableFault> find_fault(const TableView<Real>& table) {
  if (!fits_name(table.name)) return TableFault{TableError::kBadName};
  if (table.rows.empty()) return TableFault{TableError::kNoRows};
  if (!detail::is_in_order(table)) return TableFault{TableError::kBadShape};
  std::uint32_t thickness_before = 0;
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    const auto row = static_cast<std::uint16_t>(i);
    if (!detail::rises(thickness_before, table.rows[i].thickness_um, kMaxThicknessUm)) {
      return TableFault{TableError::kThicknessNotRising, row};
    }
    thickness_before = table.rows[i].thickness_um;
    if (const auto error = detail::fault_of_row(table, table.rows[i])) {
      return TableFault{*error, row};
    }
  }
  return std::nullopt;
}

}  // namespace cnc::kerf
