#pragma once

#include <cstddef>
#include <vector>

#include "host-sim/plot/view.hpp"

namespace sim {

/// A place of the picture.
struct PicturePlace {
  double x_px = 0.0;
  double y_px = 0.0;
};

/// The number of a cut where it is to be read: the left end of its base line.
struct PlacedNumber {
  std::size_t number = 0;  ///< From 1.
  PicturePlace place{};
};

struct NumberLayout {
  double size_px = 17.0;        ///< Height of the letters' square.
  double dot_px = 4.0;          ///< Radius of the mark at a pierce, which numbers leave free.
  std::size_t max_shown = 400;  ///< Of more pierces every second, fifth, tenth … has its number.
};

/// Places numbers of pierces beside them, in the order of the pierces, so that they lie neither on
/// each other nor on a pierce wherever one of the places around the pierce is free. The first and
/// the last are always there; of more than 100 pierces others without a free place are left out.
[[nodiscard]] std::vector<PlacedNumber> placed_numbers(const std::vector<PicturePlace>& pierces,
                                                       const NumberLayout& layout);

/// Returns the box that a number covers.
[[nodiscard]] Box box_of(const PlacedNumber& placed, const NumberLayout& layout);

/// Returns the size of numbers that suits a number of pierces, px.
[[nodiscard]] double number_size_px(std::size_t pierces);

}  // namespace sim
