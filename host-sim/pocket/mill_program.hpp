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

/// How a mill drives a tool path.
struct MillSettings {
  double feed_mm_min = 0.0;         ///< Along the path, above 0.
  double light_feed_mm_min = 0.0;   ///< Where passes are light; 0: the same.
  double slot_feed_mm_min = 0.0;    ///< Over surfaces, with stock on both sides; 0: the same.
  double plunge_mm_min = 0.0;       ///< Greatest feed downwards, above 0.
  double spindle_rpm = 0.0;         ///< 0 leaves the spindle alone.
  bool turns_left = false;          ///< M4 in place of M3.
  double spin_up_s = 0.0;           ///< Dwell after the spindle has been switched on.
  Coolant coolant = Coolant::kOff;  ///< Off again at the end.
  /// Number of the tool whose radius moves the tool off its path between lead-in and lead-out; 0:
  /// none. It is by how much the tool in use is larger than the one of the path.
  std::uint32_t wear_tool = 0;
  bool wears_to_left = true;  ///< By G41; else by G42, to the right.
  double safe_mm = 5.0;       ///< Z of rapids in the plane, above 0.
  /// Distance of rapids from stock, mm: a rapid descends to this height above the first point of a
  /// row, and at depth it begins and ends so far from cuts.
  double near_mm = 1.0;
};

/// Returns the lines with which every program of a mill begins: modes, the tool out of the stock,
/// then spindle and coolant.
[[nodiscard]] std::string opening_of(const MillSettings& mill);
/// Returns the lines with which it ends: coolant and spindle off.
[[nodiscard]] std::string closing_of(const MillSettings& mill);

/// Writes a tool path as G-code: spindle and coolant, then for each row a rapid at the safe height,
/// a descent to its first point, its lines, arcs and helices, and a rapid up. Feeds of ramps and
/// helices are so low that they descend no faster than a plunge. Returns at depth are rapids but
/// for their ends, where they are longer than three times `near_mm`. Throws std::invalid_argument
/// where a point is too far from zero for a program.
/// @param heading lines of comment at the top; characters that G-code cannot carry become `_`
/// @pre no stock lies above the first point of each row
[[nodiscard]] std::string program_of(const cnc::pocket::ToolPathView<double>& path,
                                     const MillSettings& mill,
                                     cnc::gcode::PrintGrid grid,
                                     const std::vector<std::string>& heading);

}  // namespace sim::pocket
