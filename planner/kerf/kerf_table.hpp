#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace cnc::kerf {

/// What λ1 is multiplied by: Q = P / V, with V in one unit or the other. The paper's printed
/// numbers hold with the first, physics suggests the second: nobody may guess, so each table says.
enum class HeatUnit : std::uint8_t {
  kWattMinutesPerMillimetre = 0,  ///< P in W over V in mm/min, "as printed".
  kJoulesPerMillimetre = 1,       ///< P in W over V in mm/s.
};

/// Where and how the beam cuts. Whole numbers: what is stored is what was said, an edge of the
/// permissible region is the same on every machine, and differences lose no digits.
struct Condition {
  std::uint32_t thickness_um = 0;
  std::uint32_t power_mw = 0;
  std::uint32_t speed_um_min = 0;
  constexpr bool operator==(const Condition&) const = default;
};

/// How wide one speed cuts, as measured.
struct Point {
  std::uint32_t speed_um_min = 0;
  std::uint32_t kerf_nm = 0;
  constexpr bool operator==(const Point&) const = default;
};

/// The speeds at which one power cuts one thickness well, and what was measured there
/// where the linear law does not hold.
struct Band {
  std::uint32_t power_mw = 0;
  std::uint32_t least_um_min = 0;
  std::uint32_t most_um_min = 0;
  std::uint16_t first_point = 0;  ///< Of the table's points…
  std::uint16_t points = 0;       ///< …so many; none in a row with a law.
  constexpr bool operator==(const Band&) const = default;
};

/// kerf = slope · Q + intercept, mm.
template <typename Real>
struct Law {
  Real slope = 0;      ///< λ1, mm per unit of Q.
  Real intercept = 0;  ///< λ2, mm.
  constexpr bool operator==(const Law&) const = default;
};

/// All that is known of one thickness. Source: Park and Ahn 2007, Tables 2 and 3.
template <typename Real>
struct Row {
  std::uint32_t thickness_um = 0;
  Law<Real> law{};               ///< Unused where it was measured.
  bool measured = false;         ///< The bands' points count, not the law.
  std::uint16_t first_band = 0;  ///< Of the table's bands…
  std::uint16_t bands = 0;       ///< …so many, of rising power.
  constexpr bool operator==(const Row&) const = default;
};

/// The kerf of one material as rows, bands and points of somebody else's memory:
/// constant in flash, bounded in RAM, or a host's vectors. Single precision on the controller.
template <typename Real>
struct TableView {
  std::string_view name{};
  HeatUnit unit = HeatUnit::kWattMinutesPerMillimetre;
  std::span<const Row<Real>> rows{};  ///< Of rising thickness.
  std::span<const Band> bands{};
  std::span<const Point> points{};

  [[nodiscard]] constexpr std::span<const Band> bands_of(const Row<Real>& row) const {
    return bands.subspan(row.first_band, row.bands);
  }
  [[nodiscard]] constexpr std::span<const Point> points_of(const Band& band) const {
    return points.subspan(band.first_point, band.points);
  }
};

// What a table may hold at all: beyond it single precision would no longer keep the error below
// a micrometre.
inline constexpr std::uint32_t kMostThicknessUm = 100'000;
inline constexpr std::uint32_t kMostPowerMw = 100'000'000;
inline constexpr std::uint32_t kLeastSpeedUmMin = 1'000;
inline constexpr std::uint32_t kMostSpeedUmMin = 1'000'000'000;
inline constexpr std::uint32_t kMostKerfNm = 10'000'000;
inline constexpr float kMostInterceptMm = 10.0F;
inline constexpr std::size_t kLongestName = 15;

enum class TableError : std::uint8_t {
  kBadName,             ///< Empty, too long, or letters that a line of text could not carry.
  kNoRows,              ///< Neither a thickness nor a power.
  kThicknessNotRising,  ///< Or none, or beyond the range.
  kPowerNotRising,
  kBadSpeeds,  ///< None, beyond the range, or the least above the greatest.
  kBadPoints,  ///< Not rising, or not from the least speed to the greatest.
  kBadKerf,    ///< Somewhere in the region it is not above 0 and at most 10 mm.
  kBadShape,   ///< Bands or points that belong to no row, or to two.
  // Of an image of a table.
  kBadSize,
  kNotATable,
  kOtherVersion,
  kBadSum,
  kTooManyRows,
  kTooManyBands,
  kTooManyPoints,
};

/// What is wrong with a table, and where.
struct TableFault {
  TableError error = TableError::kBadName;
  std::uint16_t row = 0;       ///< From 0; of the errors of rows.
  std::uint16_t count = 0;     ///< Of kTooMany…: so many there are…
  std::uint16_t capacity = 0;  ///< …and so many fit.
};

/// One clause, without the numbers of the fault.
[[nodiscard]] std::string_view describe(TableError error);

/// What a name may be made of: it stands in lines of text, between commas and brackets.
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
