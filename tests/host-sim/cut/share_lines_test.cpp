#include "host-sim/cut/share_lines.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <deque>
#include <string>
#include <vector>

#include "host-sim/import/curve_measure.hpp"
#include "tests/host-sim/cut/support.hpp"
#include "tests/support/random_source.hpp"
#include "tests/support/trials.hpp"

namespace sim::cut {
namespace {

constexpr double kTolerance = 0.02;

struct Rectangle {
  double x = 0.0;
  double y = 0.0;
  double width = 0.0;
  double height = 0.0;
};

std::string text_of(const Rectangle& r) {
  return fmt::format(
      "<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"/>", r.x, r.y, r.width, r.height);
}

/// Rows of parts, a kerf apart or a little more; their sides may stand above each other or not.
std::vector<Rectangle> random_rows(proof::Random& random) {
  std::vector<Rectangle> parts;
  const bool is_grid = random.chance(0.5);
  const double gap = kTestKerf + (random.chance(0.5) ? 0.0 : random.between(0.0, kTolerance));
  double y = 5.0;
  const std::size_t rows = 1 + random.below(4);
  const std::size_t columns = 1 + random.below(4);
  for (std::size_t row = 0; row < rows; ++row) {
    const double height = random.between(4.0, 9.0);
    double x = is_grid ? 5.0 : random.between(5.0, 12.0);
    for (std::size_t column = 0; column < columns; ++column) {
      const double width = is_grid ? 7.0 : random.between(4.0, 9.0);
      parts.push_back({x, y, width, height});
      x += width + gap;
    }
    y += height + gap;
  }
  // In any order.
  for (std::size_t i = parts.size(); i > 1; --i) std::swap(parts[i - 1], parts[random.below(i)]);
  return parts;
}

drawing::Drawing drawing_of(const std::vector<Rectangle>& parts) {
  std::string content;
  for (const Rectangle& part : parts) content += text_of(part);
  return drawing::read(drawing::svg_of(content));
}

LayerSettings sharing() { return {.common_line_mm = kTolerance}; }

double lit_mm(const CutPlan& plan) {
  double sum = 0.0;
  for (const Cut& cut : plan.cuts) {
    for (const Stroke& stroke : cut.strokes) {
      if (stroke.purpose == Purpose::kContour) sum += length_of(stroke);
    }
  }
  return sum;
}

/// The material that the beam leaves of a sheet, in small squares.
class Sheet {
 public:
  explicit Sheet(const CutPlan& plan) : burnt_(kCells * kCells, false) {
    for (const Cut& cut : plan.cuts) {
      for (const Stroke& stroke : cut.strokes) {
        for (const Place& place : places_along(stroke, 0.25 * kCell)) burn(place);
      }
    }
  }

  /// Returns whether a way through the material leads from one place to the other.
  [[nodiscard]] bool joins(const Place& from, const Place& to) const {
    std::vector<bool> seen = burnt_;
    std::deque<std::size_t> open{cell(from)};
    seen[open.front()] = true;
    while (!open.empty()) {
      const std::size_t here = open.front();
      open.pop_front();
      if (here == cell(to)) return true;
      const std::size_t x = here % kCells;
      const std::size_t y = here / kCells;
      const auto go = [&](bool is_inside, std::size_t there) {
        if (!is_inside || seen[there]) return;
        seen[there] = true;
        open.push_back(there);
      };
      go(x > 0, here - 1);
      go(x + 1 < kCells, here + 1);
      go(y > 0, here - kCells);
      go(y + 1 < kCells, here + kCells);
    }
    return false;
  }

 private:
  static constexpr double kCell = 0.08;  ///< mm.
  static constexpr std::size_t kCells = 700;

  static std::size_t index(double mm) { return static_cast<std::size_t>(mm / kCell); }
  static std::size_t cell(const Place& place) {
    return index(place.y()) * kCells + index(place.x());
  }

  void burn(const Place& place) {
    for (std::size_t y = index(place.y() - kHalf); y <= index(place.y() + kHalf); ++y) {
      for (std::size_t x = index(place.x() - kHalf); x <= index(place.x() + kHalf); ++x) {
        const Place middle{(static_cast<double>(x) + 0.5) * kCell,
                           (static_cast<double>(y) + 0.5) * kCell};
        if (drawing::distance(middle, place) <= kHalf) burnt_[y * kCells + x] = true;
      }
    }
  }

  std::vector<bool> burnt_;
};

/// In the drawing, y goes up from the lower edge of a sheet of 100 mm; the sheet above begins here.
Place middle_of(const Rectangle& part) {
  return {part.x + 0.5 * part.width, 100.0 - part.y - 0.5 * part.height};
}

TEST(ShareLines, FreeAllPartsAndCutNoneAndNoLineTwice) {
  const proof::Trials trials{60};
  std::size_t lines = 0;
  double with_mm = 0.0;
  double without_mm = 0.0;
  for (const std::uint64_t seed : trials) {
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
    proof::Random random{seed};
    std::vector<Rectangle> parts = random_rows(random);
    for (Rectangle& part : parts) part.y += 45.0;  // To the lower left of the sheet.
    const auto drawn = drawing_of(parts);
    const CutPlan plan = plan_of(drawn, sharing());
    const CutPlan whole = plan_of(drawn);
    ASSERT_TRUE(plan.faults.empty());
    std::vector<Outline> outlines;
    for (const auto& contour : drawn.contours) {
      outlines.push_back(outline_of(contour.shapes, 1.0e-4));
    }
    for (const Cut& cut : plan.cuts) {
      for (const Stroke& stroke : cut.strokes) {
        for (const Place& place : places_along(stroke, 0.2)) {
          ASSERT_GT(distance_to_all(outlines, place), kHalf - 1.0e-4);
        }
      }
    }
    const Sheet sheet{plan};
    for (std::size_t i = 0; i < parts.size(); ++i) {
      EXPECT_FALSE(sheet.joins(middle_of(parts[i]), {1.0, 1.0})) << "part " << i;
      for (std::size_t k = 0; k < i; ++k) {
        EXPECT_FALSE(sheet.joins(middle_of(parts[i]), middle_of(parts[k]))) << i << " and " << k;
      }
    }
    // Also shorter by rounds between four corners, at most so many.
    const double saved = lit_mm(whole) - lit_mm(plan) - plan.shared.length_mm;
    EXPECT_GE(saved, -1.0e-6);
    EXPECT_LE(saved, static_cast<double>(4 * parts.size()) * M_PI_2 * kHalf + 0.1);
    EXPECT_LE(plan.shared.most_off_mm, kTolerance);
    for (std::size_t i = 0; i < plan.cuts.size(); ++i) {
      for (const std::size_t before : plan.cuts[i].after) EXPECT_LT(before, i);
    }
    lines += plan.shared.lines;
    with_mm += lit_mm(plan);
    without_mm += lit_mm(whole);
  }
  std::printf(
      "%zu lines shared, %.1f %% less to cut\n", lines, 100.0 - 100.0 * with_mm / without_mm);
  if (!trials.judges_shares()) return;
  EXPECT_GT(lines, 0U);
}

/// Two squares: three sides of the second one are left, without leads.
TEST(ShareLines, LeaveAnOpenCutOfTheLaterPart) {
  const auto drawn = drawing_of({{10.0, 10.0, 20.0, 20.0}, {30.0 + kTestKerf, 10.0, 20.0, 20.0}});
  const CutPlan plan = plan_of(drawn, sharing());
  ASSERT_EQ(plan.cuts.size(), 2U);
  EXPECT_EQ(plan.shared.lines, 1U);
  EXPECT_NEAR(plan.shared.length_mm, 20.0, 1.0e-9);
  EXPECT_FALSE(plan.cuts[0].loop);
  ASSERT_TRUE(plan.cuts[1].loop);
  EXPECT_EQ(plan.cuts[1].after, std::vector<std::size_t>{0});
  EXPECT_NEAR(length_of(plan.cuts[1].strokes), 60.0 + 2.0 * M_PI * kHalf, 1.0e-6);
  EXPECT_NEAR(plan.cuts[1].start().x(), 30.0 + kHalf, 1.0e-9);
  EXPECT_NEAR(plan.cuts[1].end().x(), 30.0 + kHalf, 1.0e-9);
  const auto closed = loops_closed_by(plan.cuts);
  EXPECT_FALSE(closed[0]);
  EXPECT_EQ(closed[1], plan.cuts[1].loop);
}

/// Without the setting, with a gap that is too wide for it, or with other power each part has its
/// own lines; with a gap that is too narrow the fault says so.
TEST(ShareLines, AreForAlikeCutsAKerfApartOnly) {
  const auto pair = [](double gap) {
    return drawing_of({{10.0, 10.0, 20.0, 20.0}, {30.0 + gap, 10.0, 20.0, 20.0}});
  };
  EXPECT_EQ(plan_of(pair(kTestKerf)).shared.lines, 0U);
  EXPECT_EQ(plan_of(pair(kTestKerf + 1.01 * kTolerance), sharing()).shared.lines, 0U);
  EXPECT_EQ(plan_of(pair(kTestKerf + 0.99 * kTolerance), sharing()).shared.lines, 1U);
  const CutPlan narrow = plan_of(pair(kTestKerf - 0.05), sharing());
  ASSERT_EQ(narrow.faults.size(), 2U);
  EXPECT_EQ(narrow.faults[0].reason, "its cut takes 0.050 mm off rect");
  EXPECT_EQ(narrow.faults[0].remedy, "put them at least the kerf apart, 0.600 mm");
  const auto layered = drawing::read(
      drawing::svg_of("<rect x=\"10\" y=\"10\" width=\"20\" height=\"20\" stroke=\"red\"/>"
                      "<rect x=\"30.6\" y=\"10\" width=\"20\" height=\"20\" stroke=\"blue\"/>"));
  ASSERT_EQ(layered.layers.size(), 2U);
  EXPECT_EQ(plan_of(layered, sharing()).shared.lines, 0U);
}

/// A disc in a round recess: arcs beside arcs.
TEST(ShareLines, AreArcsToo) {
  const auto drawn =
      drawing::read(drawing::svg_of("<path d=\"M10 10H30A10.6 10.6 0 0 0 51.2 10H70V40H10Z\"/>"
                                    "<path d=\"M30.6 10A10 10 0 0 0 50.6 10Z\"/>"));
  const CutPlan plan = plan_of(drawn, sharing());
  EXPECT_TRUE(plan.faults.empty());
  EXPECT_EQ(plan.shared.lines, 1U);
  EXPECT_NEAR(plan.shared.length_mm, M_PI * (10.0 + kHalf), 1.0e-3);
}

/// Tabs stay, and what has tabs pierces and goes forwards: a tab of the other part may be there.
TEST(ShareLines, KeepTabsAndPierces) {
  const auto drawn = drawing_of({{10.0, 10.0, 20.0, 20.0}, {30.0 + kTestKerf, 10.0, 20.0, 20.0}});
  LayerSettings settings = sharing();
  settings.tabs = 3;
  settings.pierce_s = 0.2;
  const auto count = [](const Cut& cut, Purpose purpose) {
    return std::ranges::count(cut.strokes, purpose, &Stroke::purpose);
  };
  const CutPlan held = plan_of(drawn, settings);
  ASSERT_EQ(held.cuts.size(), 2U);
  EXPECT_EQ(count(held.cuts[1], Purpose::kTab), 3);
  EXPECT_EQ(held.cuts[1].strokes.front().purpose, Purpose::kPierce);
  settings.tabs = 0;
  const CutPlan free = plan_of(drawn, settings);
  EXPECT_EQ(count(free.cuts[0], Purpose::kPierce), 1);
  EXPECT_EQ(count(free.cuts[1], Purpose::kPierce), 0);
}

}  // namespace
}  // namespace sim::cut
