#pragma once

#include <optional>
#include <string>
#include <vector>

#include "host-sim/engrave/burn_raster.hpp"
#include "host-sim/import/place.hpp"
#include "planner/order/rapid_time.hpp"

namespace sim::engrave {

/// Settings for driving the rows of a picture.
struct EngraveSettings {
  drawing::Place at_mm{0.0, 0.0};  ///< Position of the lower left corner of the picture.
  double feed_mm_min = 3000.0;
  double overscan_mm = 2.0;       ///< Length of the beam-off motion before and after each row.
  double reverse_shift_mm = 0.0;  ///< Distance added to X in rows that are driven backwards.
  bool is_one_way = false;        ///< Whether all rows are driven from left to right.
  bool is_plain = false;          ///< Whether each line has at most one S, as every Grbl requires.
  bool follows_speed = true;      ///< True: M4, where the power follows the speed. False: M3.
  double full_power_s = 1000.0;   ///< S value of full power: setting $30.
  std::string air = "M8";  ///< Word that switches the air assist on, M7 or M8; empty: no word.
  int decimals = 4;        ///< Number of decimals of positions.
};

/// Figures of an engraving program.
struct EngraveFigures {
  std::size_t rows = 0;      ///< Number of rows with a burnt pixel; other rows are skipped.
  std::size_t lines = 0;     ///< Number of lines of the program, without its heading.
  double burnt_mm = 0.0;     ///< Length with the beam on.
  double estimated_s = 0.0;  ///< Duration of the program, estimated from feeds and accelerations.
  /// Lower left corner of the box in which the head moves, including overscan.
  drawing::Place low{0.0, 0.0};
  drawing::Place high{0.0, 0.0};
};

/// One row as it is driven. The beam is off before `from_mm` and after `to_mm`.
struct EngravedRow {
  double y_mm = 0.0;
  double start_mm = 0.0;  ///< X at which the overscan before the row begins.
  /// X at which the first burnt pixel begins, in the direction of the motion.
  double from_mm = 0.0;
  double to_mm = 0.0;   ///< X at which the last burnt pixel ends, in the direction of the motion.
  double end_mm = 0.0;  ///< X at which the overscan after the row ends.
};

/// The lines that burn a picture while M4 or M3 is active, with their rows and figures.
struct EngravedRows {
  std::string text;
  EngraveFigures figures;
  std::vector<EngravedRow> rows;
};

/// Returns the rows of a raster, from the bottom. Each row is driven only along its burnt part.
/// Rows without a burnt pixel are omitted. The first line is a rapid. At the end, the beam is off,
/// and G1, F and S0 are active. Returns none for a white picture.
[[nodiscard]] std::optional<EngravedRows> engrave_rows(const BurnRaster& raster,
                                                       const EngraveSettings& settings,
                                                       const cnc::order::RapidLimits& limits);

/// A program with its figures.
struct EngraveProgram {
  std::string text;
  EngraveFigures figures;
};

/// Returns the program that burns a raster with the rows of engrave_rows(). Returns none for a
/// white picture.
/// @param heading comments at the top
[[nodiscard]] std::optional<EngraveProgram> engrave_program(
    const BurnRaster& raster,
    const EngraveSettings& settings,
    const cnc::order::RapidLimits& limits,
    const std::vector<std::string>& heading);

}  // namespace sim::engrave
