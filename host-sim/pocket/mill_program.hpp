#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "planner/gcode/print_grid.hpp"
#include "planner/pocket/tool_path.hpp"

namespace sim::pocket {

enum class Coolant : std::uint8_t {
  kOff,
  kMist,   ///< M7.
  kFlood,  ///< M8.
};

/// Settings with which a mill drives a tool path.
struct MillSettings {
  double feed_mm_min = 0.0;        ///< Along the path, above 0.
  double light_feed_mm_min = 0.0;  ///< Feed of light passes; 0: `feed_mm_min`.
  /// Feed over surfaces with stock on both sides; 0: `feed_mm_min`.
  double slot_feed_mm_min = 0.0;
  double plunge_mm_min = 0.0;       ///< Greatest feed downwards, above 0.
  double spindle_rpm = 0.0;         ///< 0 gives the spindle no command.
  bool turns_left = false;          ///< Whether M4 is used in place of M3.
  double spin_up_s = 0.0;           ///< Dwell after the spindle has been switched on.
  Coolant coolant = Coolant::kOff;  ///< Switched off at the end.
  /// Number of the tool whose radius offsets the path between lead-in and lead-out; 0: no offset.
  /// This radius is the excess of the tool in use over the tool of the path.
  std::uint32_t wear_tool = 0;
  bool wears_to_left = true;  ///< True for G41; false for G42, to the right.
  double safe_mm = 5.0;       ///< Z of rapids in the plane, above 0.
  /// Distance of rapids from stock, mm. A rapid descends to this height above the first point of a
  /// row. At depth, it begins and ends at this distance from cuts.
  double near_mm = 1.0;
};

/// Returns the first lines of every program of a mill: modes, the tool's motion out of the stock,
/// then spindle and coolant.
[[nodiscard]] std::string opening_of(const MillSettings& mill);
/// Returns the last lines of every program: coolant and spindle off.
[[nodiscard]] std::string closing_of(const MillSettings& mill);

/// Returns a tool path as G-code: spindle and coolant, then the rows. Each row has a rapid at the
/// safe height, a descent to its first point, its lines, arcs and helices, and a rapid up. Feeds of
/// ramps and helices are limited so that they descend no faster than a plunge. A return at depth is
/// a rapid except for its ends, if it is longer than three times `near_mm`. Throws
/// std::invalid_argument where a point is too far from zero for a program.
/// @param heading lines of comment at the top; characters that G-code cannot carry become `_`
/// @pre no stock lies above the first point of each row
[[nodiscard]] std::string program_of(const cnc::pocket::ToolPathView<double>& path,
                                     const MillSettings& mill,
                                     cnc::gcode::PrintGrid grid,
                                     const std::vector<std::string>& heading);

}  // namespace sim::pocket
