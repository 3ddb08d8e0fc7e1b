#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "host-sim/import/place.hpp"

namespace sim {

/// Power and feed of a square, or of the slots.
struct GridCondition {
  double power_percent = 0.0;  ///< Of full power.
  double feed_mm_min = 0.0;
};

/// A grid of squares: each column has a power, each row a feed; and slots for a caliper above it.
struct TestGrid {
  std::string material{};
  double thickness_mm = 0.0;  ///< 0: not known.
  std::string laser{};
  bool is_filled = false;  ///< Squares are filled with lines; else their outline is cut.
  std::vector<double> powers_percent{};
  std::vector<double> feeds_mm_min{};
  std::size_t passes = 1;
  double cell_mm = 8.0;
  double gap_mm = 4.0;
  double interval_mm = 0.1;  ///< From line to line of filled squares.
  double label_mm = 3.0;     ///< Height of capitals.
  GridCondition labels{10.0, 3000.0};
  GridCondition slots{};
  std::vector<double> slots_mm{};  ///< Widths of the slots' paths.
  double slot_length_mm = 15.0;
};

/// How the program of a grid is written.
struct GridProgram {
  drawing::Place at_mm{0.0, 0.0};  ///< The lower left corner.
  double full_power_s = 1000.0;    ///< $30.
  bool follows_speed = true;       ///< M4; else M3.
  std::string air = "M8";          ///< M7 or M8; empty: none.
};

/// Returns the height of labels that fit below the squares, at most `label_mm`. Throws
/// std::invalid_argument with the cell that is needed where no legible height does.
[[nodiscard]] double label_height(const TestGrid& grid);

/// Returns width and height of the grid with labels and slots, mm. Throws as label_height().
[[nodiscard]] drawing::Place size_of(const TestGrid& grid);

/// Returns the program: labels first, then the squares, then the slots; lines of G0 and G1 only, as
/// any Grbl reads them. Throws as label_height().
/// @param heading comments at the top
[[nodiscard]] std::string program_of(const TestGrid& grid,
                                     const GridProgram& program,
                                     const std::vector<std::string>& heading);

/// Returns values from the least to the greatest, equally far apart.
/// @pre count is 1 and both are the same, or count is 2 or more
[[nodiscard]] std::vector<double> steps_between(double least, double most, std::size_t count);

}  // namespace sim
