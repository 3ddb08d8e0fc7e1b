#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "planner/gcode/print_grid.hpp"
#include "planner/pocket/tool_path.hpp"

namespace sim::pocket {

enum class Coolant : std::uint8_t {
  kOff,
  kMist,   ///< Mist: M7.
  kFlood,  ///< Flood: M8.
};

/// Settings with which a mill drives a tool path.
struct MillSettings {
  double feed_mm_min = 0.0;        ///< Feed along the path, above 0.
  double light_feed_mm_min = 0.0;  ///< Feed of light passes (Use::kLight); 0: `feed_mm_min`.
  /// Feed of passes with stock on both sides, on surfaces; 0: `feed_mm_min`.
  double slot_feed_mm_min = 0.0;
  double plunge_mm_min = 0.0;  ///< Greatest feed downwards, above 0.
  double spindle_rpm = 0.0;    ///< Speed of the spindle; 0: the program has no spindle command.
  bool turns_left = false;     ///< Whether the program starts the spindle with M4 instead of M3.
  double spin_up_s = 0.0;      ///< Dwell after the spindle start, s.
  Coolant coolant = Coolant::kOff;  ///< Coolant during the cut; it is switched off at the end.
  /// Number of the tool whose radius offsets the path between lead-in and lead-out; 0: no offset.
  /// Its radius in the tool table is a difference: the radius of the tool in use minus the radius
  /// for which the path was computed.
  std::uint32_t wear_tool = 0;
  bool wears_to_left = true;  ///< True: G41, offset to the left. False: G42, to the right.
  double safe_mm = 5.0;       ///< Height (Z) of rapids in the plane, mm; above 0.
  /// Distance that rapids keep from stock, mm. Before a row, a rapid descends to this height above
  /// the row's first point. At depth, a rapid begins and ends at this distance from cuts.
  double near_mm = 1.0;
};

/// Returns the first lines of every mill program: modes, the tool's motion out of the stock, then
/// spindle and coolant.
[[nodiscard]] std::string opening_of(const MillSettings& mill);
/// Returns the last lines of every mill program: coolant and spindle off.
[[nodiscard]] std::string closing_of(const MillSettings& mill);

/// Returns a tool path as G-code: spindle and coolant, then the rows. Each row has a rapid at the
/// safe height, a descent to its first point, its lines, arcs and helices, and a rapid up. Feeds of
/// ramps and helices are limited so that they descend no faster than a plunge. A return at depth
/// that is longer than three times `near_mm` is a rapid except for its ends. Throws
/// std::invalid_argument if a point is too far from zero for a program.
/// @param heading comment lines at the top; characters that G-code cannot contain become `_`
/// @pre no stock is above the first point of each row
[[nodiscard]] std::string program_of(const cnc::pocket::ToolPathView<double>& path,
                                     const MillSettings& mill,
                                     cnc::gcode::PrintGrid grid,
                                     const std::vector<std::string>& heading);

}  // namespace sim::pocket
