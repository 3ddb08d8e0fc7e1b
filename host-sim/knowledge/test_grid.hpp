#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "host-sim/import/place.hpp"

namespace sim {

/// Power and feed of one square, or of the slots.
struct GridCondition {
  double power_percent = 0.0;  ///< Percent of full power.
  double feed_mm_min = 0.0;
};

/// A test grid of squares: each column has a power, and each row a feed. Slots that are measured
/// with a caliper are above the squares.
struct TestGrid {
  std::string material{};
  double thickness_mm = 0.0;  ///< Thickness of the material; 0 if not known.
  std::string laser{};
  /// Whether squares are filled with lines; otherwise their outline is cut.
  bool is_filled = false;
  std::vector<double> powers_percent{};
  std::vector<double> feeds_mm_min{};
  std::size_t passes = 1;
  double cell_mm = 8.0;
  double gap_mm = 4.0;
  double interval_mm = 0.1;  ///< Distance between the lines of filled squares.
  double label_mm = 3.0;     ///< Greatest height of a label's capitals.
  GridCondition labels{10.0, 3000.0};
  GridCondition slots{};
  std::vector<double> slots_mm{};  ///< Widths of the slots' paths.
  double slot_length_mm = 15.0;
};

/// Options of a grid's program.
struct GridProgram {
  drawing::Place at_mm{0.0, 0.0};  ///< Position of the lower left corner.
  double full_power_s = 1000.0;    ///< S of full power, $30.
  bool follows_speed = true;       ///< Whether power follows the speed (M4); otherwise M3.
  std::string air = "M8";          ///< M7 or M8; empty for no air.
};

/// Returns the greatest height of labels that fit below the squares, at most `label_mm`. Throws
/// std::invalid_argument with the required cell size if no legible height fits.
[[nodiscard]] double label_height(const TestGrid& grid);

/// Returns width and height of the grid with labels and slots, mm. Throws the exceptions of
/// label_height().
[[nodiscard]] drawing::Place size_of(const TestGrid& grid);

/// Returns the program: labels first, then the squares, then the slots. Its motions are only G0 and
/// G1, which any Grbl reads. Throws the exceptions of label_height(). @param heading comments at
/// the top
[[nodiscard]] std::string program_of(const TestGrid& grid,
                                     const GridProgram& program,
                                     const std::vector<std::string>& heading);

/// Returns `count` values from the least to the greatest at equal distances.
/// @pre count is 1 and `least` equals `most`, or count is 2 or more
[[nodiscard]] std::vector<double> steps_between(double least, double most, std::size_t count);

}  // namespace sim
