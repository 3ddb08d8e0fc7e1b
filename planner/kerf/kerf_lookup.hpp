#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

#include "planner/base/result.hpp"
#include "planner/kerf/kerf_table.hpp"

namespace cnc::kerf {

enum class RefusalReason : std::uint8_t {
  kThickness,  ///< The thickness is outside the table's range.
  /// The power does not cut this thickness, or does not cut both thicknesses of the table around
  /// it.
  kPower,
  kSpeed,  ///< At this power the thickness can be cut, but only at other speeds.
  /// No speed is permissible in all rows and bands around the power and the thickness.
  kNoSpeed,
};

/// Reason why there is no kerf, and the permissible range: the least and greatest value of the
/// refused quantity, in the unit that Condition has for it. Both values are 0 for kNoSpeed.
struct Refusal {
  RefusalReason reason = RefusalReason::kThickness;
  std::uint32_t least = 0;
  std::uint32_t most = 0;
};

/// Range from the least to the greatest value, both included.
struct Window {
  std::uint32_t least = 0;
  std::uint32_t most = 0;

  [[nodiscard]] constexpr bool holds(std::uint32_t value) const {
    return value >= least && value <= most;
  }
  [[nodiscard]] constexpr Window in_common(const Window& other) const {
    return {std::max(least, other.least), std::min(most, other.most)};
  }
};

namespace detail {

/// Indices of the two entries around a value of a rising list. Both are equal if an entry has
/// exactly the value.
struct Neighbours {
  std::size_t low = 0;
  std::size_t high = 0;
};

/// Returns the indices of the entries around a value. Evaluates each entry at most once. @pre the
/// value is within the range of the list
template <typename Entry>
constexpr Neighbours neighbours(std::span<const Entry> entries,
                                std::uint32_t Entry::*key,
                                std::uint32_t value) {
  std::size_t high = 0;
  while (high + 1 < entries.size() && entries[high].*key < value) ++high;
  const bool met = high == 0 || entries[high].*key == value;
  return {met ? high : high - 1, high};
}

/// Returns the position of `value` between `low` and `high` as a share 0…1; 0 if both are equal.
/// The differences are exact.
template <typename Real>
constexpr Real share(std::uint32_t low, std::uint32_t high, std::uint32_t value) {
  if (low == high) return Real{0};
  return static_cast<Real>(value - low) / static_cast<Real>(high - low);
}

template <typename Real>
constexpr Real between(Real low, Real high, Real share) {
  return low + (high - low) * share;
}

constexpr Window window_of(const Band& band) { return {band.min_um_min, band.max_um_min}; }

template <typename Real>
constexpr Window powers_of(const TableView<Real>& table, const Row<Real>& row) {
  const auto bands = table.bands_of(row);
  return {bands.front().power_mw, bands.back().power_mw};
}

/// Returns the speeds that the bands around the power have in common. @pre the power is within the
/// range of the bands
template <typename Real>
constexpr Window speeds_of(const TableView<Real>& table,
                           const Row<Real>& row,
                           std::uint32_t power_mw) {
  const auto bands = table.bands_of(row);
  const Neighbours around = neighbours(bands, &Band::power_mw, power_mw);
  return window_of(bands[around.low]).in_common(window_of(bands[around.high]));
}

template <typename Real>
constexpr Real measured_kerf(std::span<const Point> points, std::uint32_t speed_um_min) {
  const Neighbours around = neighbours(points, &Point::speed_um_min, speed_um_min);
  const Point& low = points[around.low];
  const Point& high = points[around.high];
  constexpr Real kNmPerMm{1'000'000};
  return between(static_cast<Real>(low.kerf_nm) / kNmPerMm,
                 static_cast<Real>(high.kerf_nm) / kNmPerMm,
                 share<Real>(low.speed_um_min, high.speed_um_min, speed_um_min));
}

/// Returns the kerf of a row, mm. @pre power and speed are permissible for the row
template <typename Real>
constexpr Real row_kerf(const TableView<Real>& table,
                        const Row<Real>& row,
                        std::uint32_t power_mw,
                        std::uint32_t speed_um_min);

}  // namespace detail

/// Returns Q in the unit of the table's laws. mW / (µm/min) equals W / (mm/min).
template <typename Real>
[[nodiscard]] constexpr Real heat_input(HeatUnit unit,
                                        std::uint32_t power_mw,
                                        std::uint32_t speed_um_min) {
  constexpr Real kSecondsOfAMinute{60};
  const Real as_printed = static_cast<Real>(power_mw) / static_cast<Real>(speed_um_min);
  return unit == HeatUnit::kWattMinutesPerMillimetre ? as_printed : kSecondsOfAMinute * as_printed;
}

template <typename Real>
constexpr Real detail::row_kerf(const TableView<Real>& table,
                                const Row<Real>& row,
                                std::uint32_t power_mw,
                                std::uint32_t speed_um_min) {
  if (!row.measured) {
    return row.law.slope * heat_input<Real>(table.unit, power_mw, speed_um_min) + row.law.intercept;
  }
  const auto bands = table.bands_of(row);
  const Neighbours around = neighbours(bands, &Band::power_mw, power_mw);
  const Band& low = bands[around.low];
  const Band& high = bands[around.high];
  return between(measured_kerf<Real>(table.points_of(low), speed_um_min),
                 measured_kerf<Real>(table.points_of(high), speed_um_min),
                 share<Real>(low.power_mw, high.power_mw, power_mw));
}

/// Returns the powers that cut this thickness. Between two thicknesses of the table, these are the
/// powers that cut both.
/// @pre the table is sound
template <typename Real>
[[nodiscard]] constexpr Result<Window, Refusal> permissible_powers(const TableView<Real>& table,
                                                                   std::uint32_t thickness_um) {
  const Window all{table.rows.front().thickness_um, table.rows.back().thickness_um};
  if (!all.holds(thickness_um)) return Refusal{RefusalReason::kThickness, all.least, all.most};
  const auto around = detail::neighbours(table.rows, &Row<Real>::thickness_um, thickness_um);
  const Window powers = detail::powers_of(table, table.rows[around.low])
                            .in_common(detail::powers_of(table, table.rows[around.high]));
  if (powers.least > powers.most) return Refusal{RefusalReason::kNoSpeed};
  return powers;
}

/// Returns the permissible speeds. For a thickness and a power of the table, these are the speeds
/// of that row and band. Between rows or bands they are the speeds common to all neighbours: from
/// the greatest of their least speeds to the least of their greatest speeds. No wider range is
/// permissible, because no measurement exists there.
/// @pre the table is sound
template <typename Real>
[[nodiscard]] constexpr Result<Window, Refusal> permissible_speeds(const TableView<Real>& table,
                                                                   std::uint32_t thickness_um,
                                                                   std::uint32_t power_mw) {
  const auto powers = permissible_powers(table, thickness_um);
  if (!powers.ok()) return powers.error();
  if (!powers.value().holds(power_mw)) {
    return Refusal{RefusalReason::kPower, powers.value().least, powers.value().most};
  }
  const auto around = detail::neighbours(table.rows, &Row<Real>::thickness_um, thickness_um);
  const Window speeds = detail::speeds_of(table, table.rows[around.low], power_mw)
                            .in_common(detail::speeds_of(table, table.rows[around.high], power_mw));
  if (speeds.least > speeds.most) return Refusal{RefusalReason::kNoSpeed};
  return speeds;
}

/// Returns the width of the cut in mm, or a refusal for every condition outside the measured
/// region. The width is interpolated linearly between thicknesses, and between measured powers and
/// speeds. In single precision it is within 0.1 µm of the exact value for any sound table (asserted
/// within 1 µm against double precision). Evaluates each row of the table at most twice, and each
/// band and point of two rows twice. Source: Park and Ahn 2007, equations 1 and 2. @pre the table
/// is sound
template <typename Real>
[[nodiscard]] constexpr Result<Real, Refusal> kerf_width(const TableView<Real>& table,
                                                         const Condition& condition) {
  const auto speeds = permissible_speeds(table, condition.thickness_um, condition.power_mw);
  if (!speeds.ok()) return speeds.error();
  if (!speeds.value().holds(condition.speed_um_min)) {
    return Refusal{RefusalReason::kSpeed, speeds.value().least, speeds.value().most};
  }
  const auto around =
      detail::neighbours(table.rows, &Row<Real>::thickness_um, condition.thickness_um);
  const Row<Real>& low = table.rows[around.low];
  const Row<Real>& high = table.rows[around.high];
  return detail::between(
      detail::row_kerf(table, low, condition.power_mw, condition.speed_um_min),
      detail::row_kerf(table, high, condition.power_mw, condition.speed_um_min),
      detail::share<Real>(low.thickness_um, high.thickness_um, condition.thickness_um));
}

}  // namespace cnc::kerf
