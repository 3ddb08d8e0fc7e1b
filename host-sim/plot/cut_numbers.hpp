#pragma once

#include <cstddef>
#include <vector>

#include "host-sim/plot/view.hpp"

namespace sim {

/// A point of the picture.
struct PicturePlace {
  double x_px = 0.0;
  double y_px = 0.0;
};

/// The number of a cut with its position: the left end of its base line.
struct PlacedNumber {
  std::size_t number = 0;  ///< Number of the cut, from 1.
  PicturePlace place{};
};

struct NumberLayout {
  double size_px = 17.0;        ///< Height of the letters' square.
  double dot_px = 4.0;          ///< Radius of the mark at a pierce, which numbers do not cover.
  std::size_t max_shown = 400;  ///< If exceeded, every second, fifth, tenth … pierce has a number.
};

/// Places the numbers of pierces next to them, and returns them in the order of the pierces. A
/// number covers neither another number nor a pierce if one of the positions around its pierce is
/// free. The first and the last number are always placed. With more than 100 pierces, other numbers
/// without a free position are left out.
[[nodiscard]] std::vector<PlacedNumber> placed_numbers(const std::vector<PicturePlace>& pierces,
                                                       const NumberLayout& layout);

/// Returns the box that a number covers.
[[nodiscard]] Box box_of(const PlacedNumber& placed, const NumberLayout& layout);

/// Returns the size of the numbers for a picture with this number of pierces, px.
[[nodiscard]] double number_size_px(std::size_t pierces);

}  // namespace sim
