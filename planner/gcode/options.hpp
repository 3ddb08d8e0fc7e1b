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

/// Options for reading G-code, which the user may set.
struct Options {
  bool block_delete = true;  ///< True if lines that begin with / are skipped, as in LinuxCNC; $890.
  /// True during a tool change. Then only motions, probes, dwells, offsets and tool lengths are
  /// accepted.
  bool changes_tool = false;
  /// True if G43.4 is possible, which keeps the tip at its position while rotary axes turn.
  bool five_axes = false;
  ArcTolerance arc{};
  std::uint32_t highest_tool = 255;            ///< Greatest T; the default is the limit of Grbl.
  bool laser = false;                          ///< True if S may have several values in a line.
  float highest_spindle_speed = 1'000'000.0F;  ///< Greatest S, in rpm or in the scale of the laser.
  /// Greatest distance of each axis from machine zero in both directions. It may be less than the
  /// range of a Coordinate, because of the motors' step counters.
  Position reach = kFarthestPosition;
  float largest_path_tolerance_mm = 10.0F;  ///< Greatest P and Q of G64, mm; the same as for $11.
  float widest_cut_mm = 100.0F;             ///< Greatest D of G41.1, mm.
  /// Kerf table for M190, G41 and G42; null if there is none.
  const kerf::SelectedTable* kerf = nullptr;
  float full_power_speed = 1000.0F;  ///< S at the beam's greatest power, $30.
  /// Greatest power of the beam, mW; 0 if it is not known.
  std::uint32_t greatest_power_mw = 0;
  /// Greatest duration of a dwell: one day. A longer P was probably meant in milliseconds.
  float longest_dwell_s = 86'400.0F;
  /// Greatest duration of a motion: 30 days. A longer motion is a mistake in F or, in G93, in the
  /// unit of F.
  float longest_motion_s = 2'592'000.0F;
};

}  // namespace cnc::gcode
