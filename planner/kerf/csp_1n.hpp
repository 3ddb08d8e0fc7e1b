#pragma once

#include <array>

#include "planner/kerf/table_check.hpp"

/// Kerf table of rolled steel CSP 1N, cut with a CW Nd:YAG laser of at most 2.8 kW, 1.06 µm, spot
/// 0.6 mm, gas at 0.1 MPa. Source: Park and Ahn 2007, Tables 2 and 3.
namespace cnc::kerf {
namespace csp_1n {

inline constexpr std::uint32_t kWatt = 1'000;                // mW
inline constexpr std::uint32_t kMetrePerMinute = 1'000'000;  // µm/min

constexpr Band band(std::uint32_t watts, std::uint32_t min_m_min, std::uint32_t max_m_min) {
  return {watts * kWatt, min_m_min * kMetrePerMinute, max_m_min * kMetrePerMinute};
}

/// Bands of Table 2.
inline constexpr std::array<Band, 16> kBands{{
    band(1200, 4, 10),
    band(1400, 4, 10),
    band(1600, 5, 9),
    band(1800, 5, 9),  // 0.5 mm
    band(1200, 4, 6),
    band(1400, 4, 7),
    band(1600, 4, 7),
    band(1800, 4, 7),  // 1.0 mm
    band(1200, 2, 5),
    band(1400, 2, 5),
    band(1600, 3, 5),
    band(1800, 3, 5),  // 1.6 mm
    band(1200, 3, 4),
    band(1400, 3, 5),
    band(1600, 3, 5),
    band(1800, 3, 5),  // 2.0 mm
}};

// clang-tidy reports a false positive for constexpr templates.
// NOLINTBEGIN(bugprone-dynamic-static-initializers)

/// Rows of Table 3.
template <typename Real>
inline constexpr std::array<Row<Real>, 4> kRows{{
    {500, {static_cast<Real>(0.0097), static_cast<Real>(0.398)}, false, 0, 4},
    {1000, {static_cast<Real>(0.0085), static_cast<Real>(0.441)}, false, 4, 4},
    {1600, {static_cast<Real>(0.0053), static_cast<Real>(0.546)}, false, 8, 4},
    {2000, {static_cast<Real>(0.0061), static_cast<Real>(0.560)}, false, 12, 4},
}};

}  // namespace csp_1n

/// Kerf table in which the heat input Q, the power divided by the speed, is in W/(mm/min), as
/// printed by Park and Ahn 2007. It gives 0.56 mm for their worked example. Its widths hardly
/// depend on the speed.
template <typename Real>
inline constexpr TableView<Real> kCsp1n{
    "CSP 1N", HeatUnit::kWattMinutesPerMillimetre, csp_1n::kRows<Real>, csp_1n::kBands, {}};

/// Kerf table with the same numbers, but with the heat input Q in J/mm. It agrees with the figures
/// and correlations of Park and Ahn 2007, but gives 0.72 mm for their worked example. A test cut
/// shows which of the two tables is right for a machine.
template <typename Real>
inline constexpr TableView<Real> kCsp1nPhysical{
    "CSP 1N J/mm", HeatUnit::kJoulesPerMillimetre, csp_1n::kRows<Real>, csp_1n::kBands, {}};

// NOLINTEND(bugprone-dynamic-static-initializers)

static_assert(!find_fault(kCsp1n<float>) && !find_fault(kCsp1n<double>));
static_assert(!find_fault(kCsp1nPhysical<float>) && !find_fault(kCsp1nPhysical<double>));

}  // namespace cnc::kerf
