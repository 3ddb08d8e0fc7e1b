#include "host-sim/cut/share_lines.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "host-sim/import/curve_measure.hpp"
#include "tests/host-sim/cut/burnt_sheet.hpp"
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

enum class Gap { kKerf, kNone };

/// Returns rows of parts, a kerf apart or a little more, or edge to edge. Their sides may be
/// aligned with those of the next row or not.
std::vector<Rectangle> random_rows(proof::Random& random, Gap wanted = Gap::kKerf) {
  std::vector<Rectangle> parts;
  const bool is_grid = random.chance(0.5);
  const double kerf = kTestKerf + (random.chance(0.5) ? 0.0 : random.between(0.0, kTolerance));
  const double gap = wanted == Gap::kKerf ? kerf : 0.0;
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
  // The parts are listed in random order.
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

/// In the drawing, y points up from the lower edge of a sheet of 100 mm; in the parts, y points
/// down from its upper edge.
Place middle_of(const Rectangle& part) {
  return {part.x + 0.5 * part.width, 100.0 - part.y - 0.5 * part.height};
}

TEST(ShareLines, FreeAllPartsAndCutNoneAndNoLineTwice) {
  const proof::Trials trials{20};
  std::size_t lines = 0;
  double with_mm = 0.0;
  double without_mm = 0.0;
  for (const std::uint64_t seed : trials) {
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
    proof::Random random{seed};
    std::vector<Rectangle> parts = random_rows(random);
    // Moves the parts to the lower left of the sheet.
    for (Rectangle& part : parts) part.y += 45.0;
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
    const BurntSheet sheet{plan};
    for (std::size_t i = 0; i < parts.size(); ++i) {
      EXPECT_FALSE(sheet.are_one(middle_of(parts[i]), {1.0, 1.0})) << "part " << i;
      for (std::size_t k = 0; k < i; ++k) {
        EXPECT_FALSE(sheet.are_one(middle_of(parts[i]), middle_of(parts[k]))) << i << " and " << k;
      }
    }
    // The beam's path is also shorter by the rounds between four corners, at most by this length.
    const double saved = lit_mm(whole) - lit_mm(plan) - plan.shared.length_mm;
    EXPECT_GE(saved, -1.0e-6);
    EXPECT_LE(saved, static_cast<double>(4 * parts.size()) * M_PI_2 * kHalf + 0.1);
    EXPECT_LE(plan.shared.max_off_mm, kTolerance);
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

/// Two squares share a side: three sides of the second square remain, without leads.
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

/// Each part has separate lines without the setting, with a gap that is too wide for it, or with
/// different power. If the gap is too narrow, a fault reports it.
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
  EXPECT_THAT(narrow.faults[0].remedy,
              testing::StartsWith("place them at least the kerf apart, 0.600 mm, or cut once "));
  EXPECT_EQ(plan_of(pair(0.02), sharing()).faults.at(0).reason, "its cut takes 0.300 mm off rect");
  const auto layered = drawing::read(
      drawing::svg_of("<rect x=\"10\" y=\"10\" width=\"20\" height=\"20\" stroke=\"red\"/>"
                      "<rect x=\"30.6\" y=\"10\" width=\"20\" height=\"20\" stroke=\"blue\"/>"));
  ASSERT_EQ(layered.layers.size(), 2U);
  EXPECT_EQ(plan_of(layered, sharing()).shared.lines, 0U);
}

/// If parts lie edge to edge, no space remains for a cut: the fault reports the position and a
/// remedy.
TEST(ShareLines, AreAskedForWherePartsLieAgainstEachOther) {
  const CutPlan whole =
      plan_of(drawing_of({{10.0, 10.0, 20.0, 20.0}, {30.0, 10.0, 20.0, 20.0}}), {});
  ASSERT_EQ(whole.faults.size(), 2U);
  for (const drawing::Fault& fault : whole.faults) {
    EXPECT_TRUE(fault.is_error());
    EXPECT_EQ(fault.reason, "touches rect along 20.000 mm, without space for a cut between them");
    EXPECT_EQ(fault.remedy,
              "move them the kerf apart, 0.600 mm, or cut along the edge with --common-line, which "
              "takes half a kerf off both");
    ASSERT_TRUE(fault.place_mm);
    EXPECT_NEAR(fault.place_mm->x(), 30.0, 1.0e-6);
    EXPECT_NEAR(fault.place_mm->y(), 80.0, 1.0e-6);
  }
  // A small part lies at the middle of a long side, and one in a hole of its own shape.
  const CutPlan shifted =
      plan_of(drawing_of({{10.0, 10.0, 40.0, 20.0}, {20.0, 30.005, 15.0, 9.0}}), {});
  ASSERT_EQ(shifted.faults.size(), 2U);
  EXPECT_EQ(shifted.faults[1].reason,
            "touches rect along 15.000 mm, without space for a cut between them");
  const auto in_hole =
      drawing::read(drawing::svg_of("<rect x=\"10\" y=\"10\" width=\"40\" height=\"40\"/>"
                                    "<circle cx=\"30\" cy=\"30\" r=\"10\"/>"
                                    "<path d=\"M20.002 30A9.998 9.998 0 0 1 39.998 30Z\"/>"));
  const CutPlan round = plan_of(in_hole, {});
  ASSERT_FALSE(round.faults.empty());
  EXPECT_NE(round.faults[0].reason.find("touches"), std::string::npos);
}

/// Returns the depth of a point within a part, mm; nothing if it is outside.
double depth_in(const Rectangle& part, const Place& place) {
  const double top = 100.0 - part.y;
  return std::max(0.0,
                  std::min({place.x() - part.x,
                            part.x + part.width - place.x(),
                            place.y() - (top - part.height),
                            top - place.y()}));
}

/// Returns the distance of a point from the remainder of a part after all its edges have lost half
/// a kerf.
double distance_to_core(const Rectangle& part, const Place& place) {
  const double top = 100.0 - part.y;
  const auto beyond = [](double value, double from, double to) {
    return std::max({from + kHalf - value, value - to + kHalf, 0.0});
  };
  return std::hypot(beyond(place.x(), part.x, part.x + part.width),
                    beyond(place.y(), top - part.height, top));
}

/// Returns points of a part's edge that are far from all other parts.
std::vector<Place> free_edge(const std::vector<Rectangle>& parts, std::size_t number) {
  const Rectangle& part = parts[number];
  const double left = part.x;
  const double top = 100.0 - part.y;
  const std::vector<Place> corners{{left, top},
                                   {left + part.width, top},
                                   {left + part.width, top - part.height},
                                   {left, top - part.height}};
  std::vector<Place> places;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    for (const Place& place : places_along({corners[i], corners[(i + 1) % 4]}, 0.5)) {
      const auto is_near = [&](const Rectangle& other) {
        const double far = 3.0 * kTestKerf;
        const Rectangle around{
            other.x - far, other.y - far, other.width + 2.0 * far, other.height + 2.0 * far};
        return &other != &part && depth_in(around, place) > 0.0;
      };
      if (std::ranges::none_of(parts, is_near)) places.push_back(place);
    }
  }
  return places;
}

/// Returns whether two parts are nearer than the kerf without touching, at corners or across a gap.
bool are_too_near(const Rectangle& a, const Rectangle& b) {
  const double x = std::max({a.x - b.x - b.width, b.x - a.x - a.width, 0.0});
  const double y = std::max({a.y - b.y - b.height, b.y - a.y - a.height, 0.0});
  const double apart = std::hypot(x, y);
  return apart > 1.0e-6 && apart < kTestKerf + 1.0e-3;
}

/// Parts that lie edge to edge are cut along their edges, once. No cut removes more than half a
/// kerf of a part, free edges are half a kerf away from all cuts, and all parts come apart.
TEST(ShareLines, AreTheDrawnEdgesOfPartsThatLieAgainstEachOther) {
  const proof::Trials trials{15};
  std::size_t lines = 0;
  std::size_t warnings = 0;
  for (const std::uint64_t seed : trials) {
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
    proof::Random random{seed};
    std::vector<Rectangle> parts = random_rows(random, Gap::kNone);
    for (Rectangle& part : parts) part.y += 45.0;
    const auto is_near_another = [&parts](const Rectangle& part) {
      return std::ranges::any_of(
          parts, [&part](const Rectangle& other) { return are_too_near(part, other); });
    };
    if (std::ranges::any_of(parts, is_near_another)) continue;
    const CutPlan plan = plan_of(drawing_of(parts), sharing());
    for (const drawing::Fault& fault : plan.faults) {
      ADD_FAILURE() << fault.reason << " at " << fault.place_mm->transpose();
    }
    lines += plan.shared.lines;
    warnings += plan.warnings.size();
    for (std::size_t i = 0; i < parts.size(); ++i) {
      const std::vector<Place> edge = free_edge(parts, i);
      for (const Cut& cut : plan.cuts) {
        for (const Stroke& stroke : cut.strokes) {
          for (const Place& place : places_along(stroke, 0.3)) {
            ASSERT_GT(distance_to_core(parts[i], place), kHalf - 1.0e-4);
          }
          for (const Place& place : edge) {
            ASSERT_GT(distance_to(stroke, place), kHalf - 1.0e-4);
          }
        }
      }
    }
    const BurntSheet sheet{plan};
    for (std::size_t i = 0; i < parts.size(); ++i) {
      EXPECT_FALSE(sheet.are_one(middle_of(parts[i]), {1.0, 1.0})) << "part " << i;
      for (std::size_t k = 0; k < i; ++k) {
        EXPECT_FALSE(sheet.are_one(middle_of(parts[i]), middle_of(parts[k]))) << i << " and " << k;
      }
    }
    if (HasFailure()) return;
  }
  if (!trials.judges_shares()) return;
  EXPECT_GT(lines, 0U);
  EXPECT_GT(warnings, 0U);
}

/// A disc lies in a round recess, so arcs are common lines.
TEST(ShareLines, AreArcsToo) {
  const auto drawn =
      drawing::read(drawing::svg_of("<path d=\"M10 10H30A10.6 10.6 0 0 0 51.2 10H70V40H10Z\"/>"
                                    "<path d=\"M30.6 10A10 10 0 0 0 50.6 10Z\"/>"));
  const CutPlan plan = plan_of(drawn, sharing());
  EXPECT_TRUE(plan.faults.empty());
  EXPECT_EQ(plan.shared.lines, 1U);
  EXPECT_NEAR(plan.shared.length_mm, M_PI * (10.0 + kHalf), 1.0e-3);
}

/// Tabs remain. A cut with tabs pierces and runs forwards, as the other part may have a tab there.
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
