#pragma once

#include <fmt/format.h>

#include <string>

#include "tests/host-sim/cut/support.hpp"
#include "tests/support/random_source.hpp"

namespace sim::cut {

/// A sheet of rows of rectangles with rounded corners. Some of them have a round hole that contains
/// a disc.
struct RandomSheet {
  std::string content{};
  std::size_t plain = 0;
  std::size_t with_hole = 0;  ///< Number of parts with a hole; each hole contains a disc.
};

inline RandomSheet random_sheet(proof::Random& random, int columns, int rows) {
  RandomSheet sheet;
  for (int column = 0; column < columns; ++column) {
    for (int row = 0; row < rows; ++row) {
      const int x = 5 + 45 * column;
      const int y = 5 + 45 * row;
      sheet.content += fmt::format(
          R"(<rect id="p{0}_{1}" x="{2}" y="{3}" width="34" height="30" rx="{4:.2f}"/>)",
          column,
          row,
          x,
          y,
          random.between(0.5, 9.0));
      if (random.chance(0.5)) {
        ++sheet.plain;
        continue;
      }
      ++sheet.with_hole;
      sheet.content += fmt::format(
          R"(<circle cx="{0}" cy="{1}" r="11"/><circle cx="{0}" cy="{1}" r="4"/>)", x + 17, y + 15);
    }
  }
  return sheet;
}

}  // namespace sim::cut
