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

/// What the user may set about reading G-code.
struct Options {
  bool block_delete = true;  ///< Lines that begin with / are skipped, as in LinuxCNC; $890.
  /// A tool is being changed, and only lines that have to do with that are taken: motions, probes,
  /// dwells, offsets and tool lengths.
  bool changes_tool = false;
  bool five_axes = false;  ///< The machine can keep its tip in place while rotary axes turn: G43.4.
  ArcTolerance arc{};
  std::uint32_t highest_tool = 255;            ///< Grbl's limit of T.
  bool laser = false;                          ///< S may have several values in a line.
  float highest_spindle_speed = 1'000'000.0F;  ///< S in rpm, or the laser's own scale.
  /// How far from machine zero each axis can go, either way; what the motors'
  /// step counters hold may be less than what a Coordinate does.
  Position reach = kFarthestPosition;
  float largest_path_tolerance_mm = 10.0F;    ///< P and Q of G64; as $11.
  float widest_cut_mm = 100.0F;               ///< D of G41.1.
  const kerf::SelectedTable* kerf = nullptr;  ///< For M190, G41 and G42; null for none.
  float full_power_speed = 1000.0F;           ///< S of the beam's greatest power, $30,
  std::uint32_t greatest_power_mw = 0;        ///< which is this; 0: nobody knows.
  float longest_dwell_s = 86'400.0F;          ///< A day: whoever writes more meant milliseconds.
  float longest_motion_s = 2'592'000.0F;      ///< 30 days: a slip of F, or of its unit in G93.
};

}  // namespace cnc::gcode
