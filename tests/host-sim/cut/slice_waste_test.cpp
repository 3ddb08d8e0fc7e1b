#include "host-sim/cut/slice_waste.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <numeric>

#include "host-sim/import/curve_measure.hpp"
#include "tests/host-sim/cut/nesting.hpp"
#include "tests/host-sim/cut/support.hpp"
#include "tests/support/random_source.hpp"
#include "tests/support/trials.hpp"

namespace sim::cut {
namespace {

/// The sheet after the job, in cells that are whole or burnt.
class RasterSheet {
 public:
  static constexpr double kCell = 0.15;

  RasterSheet(const CutPlan& plan, const LoopArea::Box& sheet) : sheet_{sheet} {
    columns_ = static_cast<int>((sheet.x1 - sheet.x0) / kCell);
    rows_ = static_cast<int>((sheet.y1 - sheet.y0) / kCell);
    is_there_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), true);
    for (const Cut& cut : plan.cuts) {
      for (const Stroke& stroke : cut.strokes) {
        if (stroke.purpose == Purpose::kTab) continue;
        for (const Place& place : places_along(stroke, 0.05)) burn(place);
      }
    }
  }

  /// Returns width and height of the largest connected piece that is not `spared`, each as a
  /// maximum over all pieces.
  template <typename Spared>
  Place largest_piece(const Spared& spared) {
    Place largest{0.0, 0.0};
    for (int i = 0; i < columns_ * rows_; ++i) {
      if (!is_there_[static_cast<std::size_t>(i)]) continue;
      bool is_spared = false;
      const Place size = flood(i, spared, is_spared);
      if (!is_spared) largest = largest.cwiseMax(size);
    }
    return largest;
  }

 private:
  void burn(const Place& centre) {
    const int reach = static_cast<int>(kHalf / kCell) + 1;
    const int column = static_cast<int>((centre.x() - sheet_.x0) / kCell);
    const int row = static_cast<int>((centre.y() - sheet_.y0) / kCell);
    for (int x = column - reach; x <= column + reach; ++x) {
      for (int y = row - reach; y <= row + reach; ++y) {
        if (x < 0 || y < 0 || x >= columns_ || y >= rows_) continue;
        if (drawing::distance(middle(x, y), centre) <= kHalf) {
          is_there_[static_cast<std::size_t>(y * columns_ + x)] = false;
        }
      }
    }
  }

  [[nodiscard]] Place middle(int x, int y) const {
    return {sheet_.x0 + (x + 0.5) * kCell, sheet_.y0 + (y + 0.5) * kCell};
  }

  template <typename Spared>
  Place flood(int first, const Spared& spared, bool& is_spared) {
    Place least{1.0e9, 1.0e9};
    Place most{-1.0e9, -1.0e9};
    std::vector<int> open{first};
    is_there_[static_cast<std::size_t>(first)] = false;
    while (!open.empty()) {
      const int cell = open.back();
      open.pop_back();
      const int x = cell % columns_;
      const int y = cell / columns_;
      is_spared = is_spared || spared(middle(x, y));
      least = least.cwiseMin(middle(x, y));
      most = most.cwiseMax(middle(x, y));
      const auto add = [&](int to_x, int to_y) {
        if (to_x < 0 || to_y < 0 || to_x >= columns_ || to_y >= rows_) return;
        const auto next = static_cast<std::size_t>(to_y * columns_ + to_x);
        if (!is_there_[next]) return;
        is_there_[next] = false;
        open.push_back(static_cast<int>(next));
      };
      add(x + 1, y);
      add(x - 1, y);
      add(x, y + 1);
      add(x, y - 1);
    }
    return most - least + Place{kCell, kCell};
  }

  LoopArea::Box sheet_;
  int columns_ = 0;
  int rows_ = 0;
  std::vector<bool> is_there_;
};

bool has_inside(const Outline& outline, const Place& place) {
  bool inside = false;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Place& a = outline[i];
    const Place& b = outline[(i + 1) % outline.size()];
    if ((a.y() > place.y()) == (b.y() > place.y())) continue;
    const double x = a.x() + (place.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x());
    if (place.x() < x) inside = !inside;
  }
  return inside;
}

/// In a raster of the burnt sheet, no piece of waste may be larger than requested.
TEST(SliceWaste, LeavesNoLargerPiece) {
  const proof::Trials trials{8};
  std::size_t slices = 0;
  for (const std::uint64_t seed : trials) {
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
    proof::Random random{seed};
    const NestingSize size{.columns = 3,
                           .rows = 2,
                           .pitch_mm = random.between(20.0, 40.0),
                           .min_gap_mm = random.between(0.8, 6.0),
                           .levels = 1};
    const auto drawn = drawing::read(nested_sheet(random, size));
    CutPlan plan = plan_of(drawn, {.pierce_s = random.chance(0.5) ? 0.2 : 0.0});
    const std::size_t parts = plan.cuts.size();
    const LoopArea::Box sheet{-4.0, -4.0, 3.0 * size.pitch_mm + 4.0, 2.0 * size.pitch_mm + 4.0};
    const double piece = random.between(10.0, 60.0);
    slice_waste(plan, drawn, {.piece_mm = piece, .stock = sheet});
    std::vector<Outline> outlines;
    for (const auto& contour : drawn.contours) {
      outlines.push_back(outline_of(contour.shapes, 1.0e-2));
    }
    for (std::size_t i = parts; i < plan.cuts.size(); ++i) {
      EXPECT_TRUE(plan.cuts[i].is_slice);
      for (const Stroke& stroke : plan.cuts[i].strokes) {
        for (const Place& place : places_along(stroke, 0.5)) {
          EXPECT_GT(distance_to_all(outlines, place), kTestKerf - 1.2e-2);
        }
      }
    }
    const auto is_part = [&](const Place& place) {
      return std::ranges::any_of(
          outlines, [&](const Outline& outline) { return has_inside(outline, place); });
    };
    const Place largest = RasterSheet{plan, sheet}.largest_piece(is_part);
    EXPECT_LE(largest.maxCoeff(), piece + RasterSheet::kCell);
    slices += plan.cuts.size() - parts;
  }
  std::printf("%zu slices\n", slices);
  if (!trials.judges_shares()) return;
  EXPECT_GT(slices, 30U);
}

TEST(SliceWaste, StaysOnTheMachine) {
  const auto drawn =
      drawing::read(drawing::svg_of("<rect x=\"3\" y=\"30\" width=\"60\" height=\"60\"/>"));
  CutPlan plan = plan_of(drawn);
  slice_waste(plan, drawn, {.piece_mm = 40.0, .margin_mm = 50.0});
  ASSERT_GT(plan.cuts.size(), 1U);
  for (const Cut& cut : plan.cuts) {
    EXPECT_GE(std::min(cut.start().x(), cut.end().x()), 0.0);
    EXPECT_GE(std::min(cut.start().y(), cut.end().y()), 0.0);
  }
}

TEST(SliceWaste, IsNamedInTheProgram) {
  const auto drawn =
      drawing::read(drawing::svg_of("<rect x=\"30\" y=\"30\" width=\"40\" height=\"40\"/>"));
  CutPlan plan = plan_of(drawn);
  slice_waste(plan, drawn, {.piece_mm = 30.0, .margin_mm = 10.0});
  const std::string program =
      program_of(plan, drawn, {.full_power_w = 2000.0}, cnc::gcode::PrintGrid{4}, {});
  EXPECT_THAT(program, testing::HasSubstr("(2: waste, slice)\n"));
}

}  // namespace
}  // namespace sim::cut
