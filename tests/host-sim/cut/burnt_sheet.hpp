#pragma once

#include <cstddef>
#include <vector>

#include "host-sim/cut/plan.hpp"
#include "tests/host-sim/cut/support.hpp"

namespace sim::cut {

/// The material that the beam leaves of a sheet of 100 mm, as small squares that form connected
/// pieces.
class BurntSheet {
 public:
  explicit BurntSheet(const CutPlan& plan) : pieces_(kCells * kCells, kMaterial) {
    for (const Cut& cut : plan.cuts) {
      for (const Stroke& stroke : cut.strokes) {
        for (const Place& place : places_along(stroke, 0.25 * kCell)) burn(place);
      }
    }
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      if (pieces_[i] == kMaterial) fill(i, ++last_);
    }
  }

  /// Returns whether both points are in one piece of material.
  [[nodiscard]] bool are_one(const Place& a, const Place& b) const {
    return pieces_[cell(a)] != kBurnt && pieces_[cell(a)] == pieces_[cell(b)];
  }

 private:
  static constexpr double kCell = 0.05;  ///< Side of a square, mm.
  static constexpr std::size_t kCells = 2000;
  static constexpr int kMaterial = -1;
  static constexpr int kBurnt = 0;

  static std::size_t index(double mm) { return static_cast<std::size_t>(mm / kCell); }
  static std::size_t cell(const Place& place) {
    return index(place.y()) * kCells + index(place.x());
  }

  void burn(const Place& place) {
    for (std::size_t y = index(place.y() - kHalf); y <= index(place.y() + kHalf); ++y) {
      for (std::size_t x = index(place.x() - kHalf); x <= index(place.x() + kHalf); ++x) {
        const Place middle{(static_cast<double>(x) + 0.5) * kCell,
                           (static_cast<double>(y) + 0.5) * kCell};
        if (drawing::distance(middle, place) <= kHalf) pieces_[y * kCells + x] = kBurnt;
      }
    }
  }

  /// Assigns a piece's number to all material that is connected to a square.
  void fill(std::size_t from, int piece) {
    std::vector<std::size_t> open{from};
    const auto take = [&](bool is_inside, std::size_t there) {
      if (!is_inside || pieces_[there] != kMaterial) return;
      pieces_[there] = piece;
      open.push_back(there);
    };
    pieces_[from] = piece;
    while (!open.empty()) {
      const std::size_t here = open.back();
      open.pop_back();
      take(here % kCells > 0, here - 1);
      take(here % kCells + 1 < kCells, here + 1);
      take(here >= kCells, here - kCells);
      take(here + kCells < pieces_.size(), here + kCells);
    }
  }

  std::vector<int> pieces_;
  int last_ = kBurnt;
};

}  // namespace sim::cut
