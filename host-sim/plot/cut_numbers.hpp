#pragma once

#include <cstddef>
#include <vector>

#include "host-sim/plot/view.hpp"

namespace sim {

/// A point in a picture.
struct PicturePlace {
  double x_px = 0.0;
  double y_px = 0.0;
};

/// The number of a cut and its position in the picture, which is the left end of its base line.
struct PlacedNumber {
  std::size_t number = 0;  ///< Number of the cut, from 1.
  PicturePlace place{};
};

struct NumberLayout {
  double size_px = 17.0;  ///< Font size of the numbers.
  double dot_px = 4.0;    ///< Radius of the dot at a pierce. Numbers do not cover this dot.
  /// Number of pierces above which only every second, fifth, tenth … pierce has a number.
  std::size_t max_shown = 400;
};

/// Returns the numbers of pierces with positions next to their pierces, in the order of the
/// pierces. If one of the positions around a pierce is free, its number covers neither another
/// number nor a pierce. The first and the last number are always returned. If there are more than
/// 100 pierces, other numbers without a free position are left out.
[[nodiscard]] std::vector<PlacedNumber> placed_numbers(const std::vector<PicturePlace>& pierces,
                                                       const NumberLayout& layout);

/// Returns the box that a number covers.
[[nodiscard]] Box box_of(const PlacedNumber& placed, const NumberLayout& layout);

/// Returns the font size of the numbers, in px, in a picture with the given number of pierces.
[[nodiscard]] double number_size_px(std::size_t pierces);

}  // namespace sim
