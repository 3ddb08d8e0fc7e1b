#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace cnc::kerf {

/// Unit of the heat input Q = P / V, by which λ1 is multiplied. The numbers that Park and Ahn 2007
/// print hold with the first unit, but physics suggests the second. The program must not guess, so
/// each table states its unit.
enum class HeatUnit : std::uint8_t {
  kWattMinutesPerMillimetre = 0,  ///< Power P in W divided by speed V in mm/min, "as printed".
  kJoulesPerMillimetre = 1,       ///< Power P in W divided by speed V in mm/s.
};

/// Condition of a cut. The members are whole numbers for three reasons. The stored values are
/// exactly the entered values, an edge of the permissible region is the same on every machine, and
/// differences lose no digits.
struct Condition {
  std::uint32_t thickness_um = 0;
  std::uint32_t power_mw = 0;
  std::uint32_t speed_um_min = 0;
  constexpr bool operator==(const Condition&) const = default;
};

/// Kerf that was measured at one speed.
struct Point {
  std::uint32_t speed_um_min = 0;
  std::uint32_t kerf_nm = 0;
  constexpr bool operator==(const Point&) const = default;
};

/// The speeds at which one power cuts one thickness well. In a row without a law, the band also
/// refers to the kerfs that were measured at these speeds.
struct Band {
  std::uint32_t power_mw = 0;
  std::uint32_t min_um_min = 0;
  std::uint32_t max_um_min = 0;
  std::uint16_t first_point = 0;  ///< Index of the band's first point in the table's points.
  std::uint16_t points = 0;       ///< Number of the band's points; 0 in a row with a law.
  constexpr bool operator==(const Band&) const = default;
};

/// Linear law of the kerf: kerf = slope · Q + intercept, mm.
template <typename Real>
struct Law {
  Real slope = 0;      ///< λ1, mm per unit of Q.
  Real intercept = 0;  ///< λ2, mm.
  constexpr bool operator==(const Law&) const = default;
};

/// All data of one thickness. Source: Park and Ahn 2007, Tables 2 and 3.
template <typename Real>
struct Row {
  std::uint32_t thickness_um = 0;
  Law<Real> law{};               ///< Law of the kerf; unused if `measured`.
  bool measured = false;         ///< Whether the points of the bands are valid instead of the law.
  std::uint16_t first_band = 0;  ///< Index of the row's first band in the table's bands.
  std::uint16_t bands = 0;       ///< Number of the row's bands, which are in order of rising power.
  constexpr bool operator==(const Row&) const = default;
};

/// The kerf of one material: rows, bands and points in memory that the table does not own. The
/// memory may be constant in flash, bounded in RAM, or a host's vectors. The controller uses single
/// precision. A table is sound if find_fault() finds no fault in it.
template <typename Real>
struct TableView {
  std::string_view name{};
  HeatUnit unit = HeatUnit::kWattMinutesPerMillimetre;
  std::span<const Row<Real>> rows{};  ///< Rows in order of rising thickness.
  std::span<const Band> bands{};
  std::span<const Point> points{};

  [[nodiscard]] constexpr std::span<const Band> bands_of(const Row<Real>& row) const {
    return bands.subspan(row.first_band, row.bands);
  }
  [[nodiscard]] constexpr std::span<const Point> points_of(const Band& band) const {
    return points.subspan(band.first_point, band.points);
  }
};

// Limits of a table's values. Beyond them single precision would no longer keep the error below a
// micrometre.
inline constexpr std::uint32_t kMaxThicknessUm = 100'000;
inline constexpr std::uint32_t kMaxPowerMw = 100'000'000;
inline constexpr std::uint32_t kMinSpeedUmMin = 1'000;
inline constexpr std::uint32_t kMaxSpeedUmMin = 1'000'000'000;
inline constexpr std::uint32_t kMaxKerfNm = 10'000'000;
inline constexpr float kMaxInterceptMm = 10.0F;
inline constexpr std::size_t kLongestName = 15;

enum class TableError : std::uint8_t {
  kBadName,             ///< The name is empty, too long, or has characters that are not permitted.
  kNoRows,              ///< The table has no rows.
  kThicknessNotRising,  ///< Thicknesses do not rise, or a thickness is 0 or beyond the range.
  kPowerNotRising,
  kBadSpeeds,  ///< A speed is 0 or beyond the range, or the least speed is above the greatest.
  /// The speeds of the points do not rise, or do not extend from the least speed to the greatest.
  kBadPoints,
  kBadKerf,   ///< At some condition of the region the kerf is not above 0 or exceeds 10 mm.
  kBadShape,  ///< Bands or points belong to no row, or to two rows.
  // Errors of an image of a table.
  kBadSize,
  kNotATable,
  kOtherVersion,
  kBadSum,
  kTooManyRows,
  kTooManyBands,
  kTooManyPoints,
};

/// A fault of a table, and its location.
struct TableFault {
  TableError error = TableError::kBadName;
  std::uint16_t row = 0;  ///< Index of the row, from 0; used for errors of rows.
  /// For kTooMany…: number of items in the table, which exceeds the capacity.
  std::uint16_t count = 0;
  std::uint16_t capacity = 0;  ///< For kTooMany…: greatest number of items.
};

/// Returns the error as one clause, without the numbers of the TableFault.
[[nodiscard]] std::string_view describe(TableError error);

/// Returns whether a name has a permitted length and only permitted characters. A name is printed
/// in lines of text, between commas and brackets, so it must not contain commas and brackets.
[[nodiscard]] constexpr bool fits_name(std::string_view name) {
  if (name.empty() || name.size() > kLongestName) return false;
  if (name.front() == ' ' || name.back() == ' ') return false;
  for (const char c : name) {
    const bool letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
    const bool digit = c >= '0' && c <= '9';
    if (!letter && !digit && c != ' ' && c != '-' && c != '_' && c != '.' && c != '/') return false;
  }
  return true;
}

}  // namespace cnc::kerf
