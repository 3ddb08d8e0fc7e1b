#pragma once

#include <optional>
#include <string>
#include <vector>

#include "host-sim/engrave/burn_raster.hpp"
#include "host-sim/import/place.hpp"
#include "planner/order/rapid_time.hpp"

namespace sim::engrave {

/// How the rows of a picture are driven.
struct EngraveSettings {
  drawing::Place at_mm{0.0, 0.0};  ///< The lower left corner of the picture.
  double feed_mm_min = 3000.0;
  double overscan_mm = 2.0;       ///< Length of the beam-off run before and after each row.
  double reverse_shift_mm = 0.0;  ///< Added to X in rows that are driven backwards.
  bool is_one_way = false;        ///< All rows from left to right.
  bool is_plain = false;          ///< One S to a line, as any Grbl reads.
  bool follows_speed = true;      ///< M4; else M3.
  double full_power_s = 1000.0;   ///< $30.
  std::string air = "M8";         ///< M7 or M8; empty: none.
};

/// What is driven.
struct EngraveFigures {
  std::size_t rows = 0;          ///< Rows with something to burn; the others are passed over.
  std::size_t lines = 0;         ///< Of the program, without its heading.
  double burnt_mm = 0.0;         ///< Length with the beam on.
  double estimated_s = 0.0;      ///< From feeds and accelerations.
  drawing::Place low{0.0, 0.0};  ///< Box of the motion of the head, overscan included.
  drawing::Place high{0.0, 0.0};
};

/// A program and its figures.
struct EngraveProgram {
  std::string text;
  EngraveFigures figures;
};

/// Returns the program that burns a raster, row by row from the bottom: rows are begun and ended
/// where they have something to burn, and rows without are left out. Nothing for a white picture.
/// @param heading comments at the top
[[nodiscard]] std::optional<EngraveProgram> engrave_program(
    const BurnRaster& raster,
    const EngraveSettings& settings,
    const cnc::order::RapidLimits& limits,
    const std::vector<std::string>& heading);

}  // namespace sim::engrave
