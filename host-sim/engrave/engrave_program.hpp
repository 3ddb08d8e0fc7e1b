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
  int decimals = 4;               ///< Decimals of positions.
};

/// Counts of all that is driven.
struct EngraveFigures {
  std::size_t rows = 0;          ///< Rows with something to burn; the others are passed over.
  std::size_t lines = 0;         ///< The program's, without its heading.
  double burnt_mm = 0.0;         ///< Length with the beam on.
  double estimated_s = 0.0;      ///< From feeds and accelerations.
  drawing::Place low{0.0, 0.0};  ///< Box of the motion of the head, overscan included.
  drawing::Place high{0.0, 0.0};
};

/// A row as it is driven: the beam is off before `from_mm` and behind `to_mm`.
struct EngravedRow {
  double y_mm = 0.0;
  double start_mm = 0.0;  ///< X where the overscan before it begins.
  double from_mm = 0.0;   ///< X of its first pixel's near side.
  double to_mm = 0.0;     ///< X of its last pixel's far side.
  double end_mm = 0.0;    ///< X where the overscan behind it ends.
};

/// The lines that burn a picture while M4 or M3 is in force, and what they drive.
struct EngravedRows {
  std::string text;
  EngraveFigures figures;
  std::vector<EngravedRow> rows;
};

/// Returns the rows of a raster, from the bottom: rows are begun and ended where they have
/// something to burn, and rows without are left out. The first line is a rapid, the beam is off at
/// the end, and G1, F and S 0 stay in force. Nothing for a white picture.
[[nodiscard]] std::optional<EngravedRows> engrave_rows(const BurnRaster& raster,
                                                       const EngraveSettings& settings,
                                                       const cnc::order::RapidLimits& limits);

/// A program and its figures.
struct EngraveProgram {
  std::string text;
  EngraveFigures figures;
};

/// Returns the program that burns a raster, with the rows of engrave_rows(). Nothing for a white
/// picture.
/// @param heading comments at the top
[[nodiscard]] std::optional<EngraveProgram> engrave_program(
    const BurnRaster& raster,
    const EngraveSettings& settings,
    const cnc::order::RapidLimits& limits,
    const std::vector<std::string>& heading);

}  // namespace sim::engrave
