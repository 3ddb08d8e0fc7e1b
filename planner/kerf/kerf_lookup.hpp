#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

#include "planner/base/result.hpp"
#include "planner/kerf/kerf_table.hpp"

namespace cnc::kerf {

enum class RefusalReason : std::uint8_t {
  kThickness,  ///< The table has none so thin or so thick.
  kPower,      ///< It does not cut this thickness, or only one of its neighbours.
  kSpeed,      ///< Power and thickness cut, at other speeds.
  kNoSpeed,    ///< No speed is permissible for all rows around power and thickness.
};

/// Why there is no kerf, and what is permissible: least and greatest of the quantity that
/// was refused, in its unit of Condition; both 0 for kNoSpeed.
struct Refusal {
  RefusalReason reason = RefusalReason::kThickness;
  std::uint32_t least = 0;
  std::uint32_t most = 0;
};

/// From the least to the greatest, both included.
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

/// The entries around a value of a rising list; the same twice where one has it.
struct Neighbours {
  std::size_t low = 0;
  std::size_t high = 0;
};

/// @pre the value is within the list. Looks at each entry once at most.
template <typename Entry>
constexpr Neighbours neighbours(std::span<const Entry> entries,
                                std::uint32_t Entry::*key,
                                std::uint32_t value) {
  std::size_t high = 0;
  while (high + 1 < entries.size() && entries[high].*key < value) ++high;
  const bool met = high == 0 || entries[high].*key == value;
  return {met ? high : high - 1, high};
}

/// How far `value` is from `low` to `high`, 0…1; 0 where they are one. Differences are exact.
template <typename Real>
constexpr Real share(std::uint32_t low, std::uint32_t high, std::uint32_t value) {
  if (low == high) return Real{0};
  return static_cast<Real>(value - low) / static_cast<Real>(high - low);
}

template <typename Real>
constexpr Real between(Real low, Real high, Real share) {
  return low + (high - low) * share;
}

constexpr Window window_of(const Band& band) { return {band.least_um_min, band.most_um_min}; }

template <typename Real>
constexpr Window powers_of(const TableView<Real>& table, const Row<Real>& row) {
  const auto bands = table.bands_of(row);
  return {bands.front().power_mw, bands.back().power_mw};
}

/// Speeds that the bands around the power have in common. @pre the power is within them
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

/// @pre power and speed are permissible for the row
template <typename Real>
constexpr Real row_kerf(const TableView<Real>& table,
                        const Row<Real>& row,
                        std::uint32_t power_mw,
                        std::uint32_t speed_um_min);

}  // namespace detail

/// The unit in which the table's laws take Q. mW / (µm/min) is W / (mm/min).
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

/// Powers that cut this thickness; between two thicknesses, those that cut both.
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

/// Speeds that are permissible: those of the row and band, and in between of all that are around,
/// the greatest least speed to the least greatest one: nobody has cut there, so nothing is wider.
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

/// The width of the cut in mm; refused wherever nobody has cut. Straight between thicknesses,
/// and between measured powers and speeds. In single precision within 0.1 µm of the exact value
/// for any sound table (asserted within 1 µm against double precision). Looks at each row of the
/// table twice at most, and at each band and point of two rows twice.
/// Source: Park and Ahn 2007, equations 1 and 2. @pre the table is sound
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
