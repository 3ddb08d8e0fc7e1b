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

/// Returns the radius, in px, of the dot at a pierce in a picture with the given number of cuts.
[[nodiscard]] double pierce_radius_px(std::size_t cuts);

/// Append marks to a picture of cuts: rapids as dashed lines with arrow heads (add_rapids()), a dot
/// at the beginning of each cut (add_pierces()), and the numbers of the cuts next to these dots.
void add_rapids(std::string& out, const cut::CutPlan& plan, const View& view);
void add_pierces(std::string& out, const cut::CutPlan& plan, const View& view);
void add_numbers(std::string& out, const cut::CutPlan& plan, const View& view);

/// Appends a disc with a soft edge at each point where a cut begins while the sheet is still warm.
/// @param heat heat at each pierce, as returned by heat_at_pierces()
void add_heat(std::string& out,
              const cut::CutPlan& plan,
              const std::vector<double>& heat,
              const View& view);

/// Appends the arrow head of a rapid from (x1, y1) to (x2, y2).
void add_arrow_head(std::string& data, double x1_px, double y1_px, double x2_px, double y2_px);

}  // namespace sim
