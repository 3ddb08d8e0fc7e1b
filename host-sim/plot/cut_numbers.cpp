#include "host-sim/plot/cut_numbers.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <unordered_map>

namespace sim {
namespace {

/// Greatest number of pierces for which every pierce has a number, even if this number covers
/// another number.
constexpr std::size_t kMaxAllNumbered = 100;
/// Width and height of a digit in the font of the picture, as shares of the font size.
constexpr double kDigitWidth = 0.64;
constexpr double kDigitHeight = 0.76;

/// The boxes of the picture that numbers and pierces already cover, sorted by cells.
class TakenBoxes {
 public:
  [[nodiscard]] bool is_free(const Box& box) const {
    bool free = true;
    for_cells(box, [&](std::int64_t key) {
      const auto cell = cells_.find(key);
      if (cell == cells_.end()) return;
      free = free && std::ranges::none_of(cell->second, [&](const Box& other) {
               return box.left_px < other.right_px() && other.left_px < box.right_px() &&
                      box.top_px < other.bottom_px() && other.top_px < box.bottom_px();
             });
    });
    return free;
  }

  void take(const Box& box) {
    for_cells(box, [&](std::int64_t key) { cells_[key].push_back(box); });
  }

 private:
  static constexpr double kCellPx = 32.0;

  template <typename Do>
  static void for_cells(const Box& box, Do act) {
    const auto cell_of = [](double px) {
      return static_cast<std::int64_t>(std::floor(px / kCellPx));
    };
    for (std::int64_t x = cell_of(box.left_px); x <= cell_of(box.right_px()); ++x) {
      for (std::int64_t y = cell_of(box.top_px); y <= cell_of(box.bottom_px()); ++y) {
        act(x * 1'000'003 + y);
      }
    }
  }

  std::unordered_map<std::int64_t, std::vector<Box>> cells_;
};

double width_of(std::size_t number, const NumberLayout& layout) {
  double digits = 1.0;
  for (std::size_t rest = number / 10; rest != 0; rest /= 10) digits += 1.0;
  return kDigitWidth * layout.size_px * digits;
}

/// Returns the interval between pierces that have a number: 1, 2 or 5 times a power of ten. With
/// this interval, at most `max_shown` pierces have a number.
std::size_t step_for(std::size_t pierces, std::size_t max_shown) {
  if (pierces <= max_shown) return 1;
  return static_cast<std::size_t>(
      std::llround(round_step(static_cast<double>(pierces) / static_cast<double>(max_shown))));
}

/// Position of a number relative to its pierce, to the right and up, as shares of the size of the
/// number. kSides lists all positions, the preferred position first.
struct Side {
  double right;  ///< Horizontal position: −1: left of the pierce, 0: in the middle, 1: right of it.
  double up;
};
constexpr std::array<Side, 8> kSides{
    {{1, 1}, {1, -1}, {-1, 1}, {-1, -1}, {1, 0}, {-1, 0}, {0, 1}, {0, -1}}};

PlacedNumber beside(const PicturePlace& pierce,
                    std::size_t number,
                    const Side& side,
                    double away_px,
                    const NumberLayout& layout) {
  const double width = width_of(number, layout);
  const double height = kDigitHeight * layout.size_px;
  const double middle_x = pierce.x_px + side.right * (away_px + 0.5 * width);
  const double middle_y = pierce.y_px - side.up * (away_px + 0.5 * height);
  return {number, {middle_x - 0.5 * width, middle_y + 0.5 * height}};
}

std::optional<PlacedNumber> free_place(const PicturePlace& pierce,
                                       std::size_t number,
                                       const TakenBoxes& taken,
                                       const NumberLayout& layout) {
  for (const double distance : {1.0, 2.5}) {
    for (const Side& side : kSides) {
      const PlacedNumber placed =
          beside(pierce, number, side, distance * layout.dot_px + 1.0, layout);
      if (taken.is_free(box_of(placed, layout))) return placed;
    }
  }
  return std::nullopt;
}

}  // namespace

Box box_of(const PlacedNumber& placed, const NumberLayout& layout) {
  const double height = kDigitHeight * layout.size_px;
  return {placed.place.x_px, placed.place.y_px - height, width_of(placed.number, layout), height};
}

double number_size_px(std::size_t pierces) {
  if (pierces <= 60) return 17.0;
  return pierces <= 400 ? 14.0 : 11.0;
}

std::vector<PlacedNumber> placed_numbers(const std::vector<PicturePlace>& pierces,
                                         const NumberLayout& layout) {
  TakenBoxes taken;
  for (const PicturePlace& pierce : pierces) {
    taken.take({pierce.x_px - layout.dot_px,
                pierce.y_px - layout.dot_px,
                2.0 * layout.dot_px,
                2.0 * layout.dot_px});
  }
  const std::size_t step = step_for(pierces.size(), layout.max_shown);
  std::vector<PlacedNumber> numbers;
  const auto place = [&](std::size_t number, bool is_wanted) {
    const PicturePlace& pierce = pierces[number - 1];
    auto placed = free_place(pierce, number, taken, layout);
    if (!placed && is_wanted) {
      placed = beside(pierce, number, kSides[0], layout.dot_px + 1.0, layout);
    }
    if (!placed) return;
    taken.take(box_of(*placed, layout));
    numbers.push_back(*placed);
  };
  const std::size_t count = pierces.size();
  if (count != 0) place(1, true);
  if (count > 1) place(count, true);
  for (std::size_t number = 2; number < count; ++number) {
    if (number % step == 0) place(number, count <= kMaxAllNumbered);
  }
  std::ranges::sort(numbers, {}, &PlacedNumber::number);
  return numbers;
}

}  // namespace sim
