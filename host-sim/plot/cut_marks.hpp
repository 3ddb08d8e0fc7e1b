#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "host-sim/cut/plan.hpp"
#include "host-sim/plot/view.hpp"

namespace sim {

inline constexpr std::string_view kRapidColour = "#7a7f87";
inline constexpr std::string_view kHeatColour = "#d55e00";
inline constexpr double kRapidPx = 1.2;
inline constexpr std::string_view kRapidDashes = "7 6";

/// Returns the radius of the dot at a pierce for a picture with this number of cuts, px.
[[nodiscard]] double pierce_radius_px(std::size_t cuts);

/// Append marks to a picture of cuts: the rapids between cuts as dashed lines with arrow heads, a
/// dot where each cut begins, and the numbers of the cuts next to the dots.
void add_rapids(std::string& out, const cut::CutPlan& plan, const View& view);
void add_pierces(std::string& out, const cut::CutPlan& plan, const View& view);
void add_numbers(std::string& out, const cut::CutPlan& plan, const View& view);

/// Appends a soft disc at each point where a cut begins in a warm sheet.
/// @param heat as returned by heat_at_pierces()
void add_heat(std::string& out,
              const cut::CutPlan& plan,
              const std::vector<double>& heat,
              const View& view);

/// Appends the arrow head of a rapid from the first to the second point of the picture.
void add_arrow_head(std::string& data, double x1_px, double y1_px, double x2_px, double y2_px);

}  // namespace sim
