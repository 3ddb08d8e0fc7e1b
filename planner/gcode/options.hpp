#pragma once

#include <cstdint>

#include "planner/base/coordinate.hpp"
#include "planner/gcode/arc_geometry.hpp"
#include "planner/kerf/selected_table.hpp"

namespace cnc::gcode {

inline constexpr Position kFarthestPosition{Coordinate{Coordinate::kFarthestNanometres},
                                            Coordinate{Coordinate::kFarthestNanometres},
                                            Coordinate{Coordinate::kFarthestNanometres},
                                            Coordinate{Coordinate::kFarthestNanometres},
                                            Coordinate{Coordinate::kFarthestNanometres},
                                            Coordinate{Coordinate::kFarthestNanometres}};

/// Options of reading G-code that the user may set.
struct Options {
  bool block_delete = true;  ///< Lines that begin with / are skipped, as in LinuxCNC; $890.
  /// A tool is being changed, and only lines that belong to that are accepted: motions, probes,
  /// dwells, offsets and tool lengths.
  bool changes_tool = false;
  bool five_axes = false;  ///< G43.4 is possible: the tip stays where it is while rotary axes turn.
  ArcTolerance arc{};
  std::uint32_t highest_tool = 255;            ///< Greatest T; the default is Grbl's limit.
  bool laser = false;                          ///< S may have several values in a line.
  float highest_spindle_speed = 1'000'000.0F;  ///< Greatest S, in rpm or in the laser's own scale.
  /// Greatest distance of each axis from machine zero, in either direction. The motors' step
  /// counters may hold less than a Coordinate does.
  Position reach = kFarthestPosition;
  float largest_path_tolerance_mm = 10.0F;    ///< Greatest P and Q of G64, as for $11.
  float widest_cut_mm = 100.0F;               ///< Greatest D of G41.1.
  const kerf::SelectedTable* kerf = nullptr;  ///< Kerf table for M190, G41 and G42; null for none.
  float full_power_speed = 1000.0F;           ///< S of the beam's greatest power, $30.
  std::uint32_t greatest_power_mw = 0;        ///< The beam's greatest power; 0 if it is not known.
  float longest_dwell_s = 86'400.0F;          ///< A day. A longer dwell was meant in milliseconds.
  /// 30 days. A longer motion is a mistake in F, or in its unit in G93.
  float longest_motion_s = 2'592'000.0F;
};

}  // namespace cnc::gcode
