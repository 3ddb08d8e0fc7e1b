#include "host-sim/sheet/place_parts.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "host-sim/import/curve_measure.hpp"
#include "host-sim/sheet/save_sheet.hpp"
#include "tests/host-sim/sheet/support.hpp"
#include "tests/support/random_source.hpp"
#include "tests/support/trials.hpp"

namespace sim::sheet {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

const TestFiles kPartFiles{
    {"key.svg", drawing::svg_of(R"(<path id="rim" d="M10 90H40A5 5 0 0 1 45 85V60H10Z"/>
                        <circle id="eye" cx="20" cy="75" r="4" stroke="red"/>
                        <path id="mark" d="M30 70L38 70" stroke="blue"/>)")},
    {"ring.svg",
     drawing::svg_of(
         R"(<circle id="o" cx="50" cy="50" r="40"/><circle id="i" cx="50" cy="50" r="30"/>)")},
    {"bad.svg", drawing::svg_of(R"(<path id="open" d="M10 10H20V20"/>)")},
    {"sheet.json", sheet_with(R"({"drawing": "key.svg"})")}};

/// Returns the map of a point, computed from the angle alone.
drawing::Place mapped(const Placing& placing, const drawing::Place& place) {
  const double angle = placing.angle_deg * std::numbers::pi / 180.0;
  const double x = placing.mirror ? -place.x() : place.x();
  return {placing.at_mm.x() + x * std::cos(angle) - place.y() * std::sin(angle),
          placing.at_mm.y() + x * std::sin(angle) + place.y() * std::cos(angle)};
}

bool has_vertex(const drawing::DrawnContour& contour, const drawing::Place& place, double slack) {
  for (const drawing::Shape& shape : contour.shapes) {
    if (drawing::distance(start_of(shape), place) <= slack) return true;
    if (drawing::distance(end_of(shape), place) <= slack) return true;
  }
  return false;
}

TEST(PlacedParts, EachVertexLiesWhereThePlacePutsItAndArcsStayArcs) {
  const drawing::Drawing alone = drawing::read(kPartFiles.at("key.svg"));
  for (const std::uint64_t seed : proof::Trials{200}) {
    proof::Random random{seed};
    const Placing placing{{random.between(-500.0, 500.0), random.between(-500.0, 500.0)},
                          random.chance(0.3) ? 90.0 * std::floor(random.between(-4.0, 4.0))
                                             : random.between(-360.0, 360.0),
                          random.chance(0.5)};
    Sheet sheet{.file = "test.json", .parts = {{"key", "key.svg", {placing}}}};
    const auto read = [](const std::string& name) { return kPartFiles.at(name); };
    const drawing::Drawing drawn = place_parts(sheet, read, {});
    ASSERT_THAT(texts_of(drawn.faults), ElementsAre(HasSubstr("mark")));
    ASSERT_EQ(drawn.contours.size(), alone.contours.size());
    for (std::size_t i = 0; i < alone.contours.size(); ++i) {
      const auto& before = alone.contours[i];
      const auto& after = drawn.contours[i];
      EXPECT_EQ(after.entity.name, "key: " + before.entity.name);
      EXPECT_EQ(after.closed, before.closed);
      EXPECT_EQ(after.is_hole(), before.is_hole());
      EXPECT_NEAR(after.area_mm2, before.area_mm2, 1.0e-9 * (1.0 + std::abs(before.area_mm2)));
      EXPECT_NEAR(after.length_mm, before.length_mm, 1.0e-9 * before.length_mm);
      auto kinds = drawing::shapes_of(before);
      auto kinds_after = drawing::shapes_of(after);
      std::ranges::sort(kinds);
      std::ranges::sort(kinds_after);
      EXPECT_EQ(kinds, kinds_after);
      for (const drawing::Shape& shape : before.shapes) {
        EXPECT_TRUE(has_vertex(after, mapped(placing, start_of(shape)), 1.0e-9));
      }
      EXPECT_EQ(drawn.layers[after.entity.layer], alone.layers[before.entity.layer]);
    }
  }
}

TEST(PlacedParts, QuarterTurnsAreExact) {
  for (const int quarter : {-4, -3, -2, -1, 0, 1, 2, 3, 4}) {
    const drawing::Transform turned = transform_of({{0.0, 0.0}, 90.0 * quarter, false});
    for (const double value : {turned.x_axis.x(), turned.x_axis.y()}) {
      EXPECT_TRUE(value == 0.0 || std::abs(value) == 1.0) << quarter;
    }
    EXPECT_NEAR(turned.x_axis.x(), std::cos(0.5 * std::numbers::pi * quarter), 1.0e-12);
    EXPECT_NEAR(turned.x_axis.y(), std::sin(0.5 * std::numbers::pi * quarter), 1.0e-12);
  }
}

TEST(PlacedParts, CopiesAreNumberedAndLiveInTheHolesOfOthers) {
  const drawing::Drawing drawn =
      placed(sheet_with(R"({"drawing": "ring.svg", "copies": 2, "step_x_mm": 100},
                    {"drawing": "ring.svg", "name": "small", "x_mm": 0.5},
                    {"drawing": "key.svg", "x_mm": 20, "y_mm": 20})"),
             kPartFiles);
  EXPECT_THAT(drawn.parts, ElementsAre("ring #1", "ring #2", "small", "key"));
  ASSERT_THAT(drawn.contours, SizeIs(9));
  EXPECT_EQ(drawn.contours[2].entity.name, "ring #2: circle \"o\"");
  EXPECT_EQ(drawn.contours[2].entity.part, 1U);
  ASSERT_TRUE(drawn.contours[6].lies_in);
  EXPECT_FALSE(drawn.contours[6].parent) << "the hole is another part's";
  EXPECT_NE(drawn.contours[*drawn.contours[6].lies_in].entity.part, drawn.contours[6].entity.part);
}

TEST(PlacedParts, WhatCannotBePlacedIsToldByPart) {
  EXPECT_THAT(
      texts_of(placed(sheet_with(R"({"drawing": "none.svg"})"), kPartFiles).faults),
      ElementsAre("test.json: /parts/0: part \"none\": none.svg: No such file or directory; "
                  "name a drawing by its path from the sheet file"));
  EXPECT_THAT(texts_of(placed(sheet_with(R"({"drawing": "sheet.json"})"), kPartFiles).faults),
              ElementsAre(HasSubstr("sheet.json is a sheet, too; list its parts here")));
  const drawing::Drawing open =
      placed(sheet_with(R"({"drawing": "bad.svg", "copies": 3, "step_x_mm": 30})"), kPartFiles);
  EXPECT_THAT(texts_of(open.faults), testing::Each(HasSubstr("part \"bad\": bad.svg:1:")));
  EXPECT_THAT(open.faults, SizeIs(drawing::read(kPartFiles.at("bad.svg")).faults.size()));
  EXPECT_EQ(open.faults[0].kind, drawing::FaultKind::kOpen);
}

TEST(PlacedParts, NamesBeginAtTheFolderOfTheSheet) {
  const Sheet sheet{.file = "jobs/today.json", .parts = {}};
  EXPECT_EQ(resolved(sheet, "a.svg"), "jobs/a.svg");
  EXPECT_EQ(resolved(sheet, "/a.svg"), "/a.svg");
  EXPECT_EQ(resolved(Sheet{.file = "-", .parts = {}}, "a.svg"), "a.svg");
}

TEST(SavedSheet, KeepsTheDrawingWhereItIsOrMovesItOntoTheStock) {
  drawing::Drawing drawn = drawing::read(kPartFiles.at("ring.svg"));
  drawn.file = "parts/ring.svg";
  const Sheet kept = sheet_of(drawn, "jobs/ring.json", 5.0);
  EXPECT_EQ(kept.parts.at(0).drawing, "../parts/ring.svg");
  EXPECT_EQ(kept.parts.at(0).places.at(0), Placing{});
  EXPECT_NEAR(kept.stock->width_mm, 95.0, 0.01);
  const Sheet moved = sheet_of(drawn, "jobs/ring.json", 15.0);
  EXPECT_NEAR(moved.parts.at(0).places.at(0).at_mm.x(), 5.0, 0.01);
  EXPECT_NEAR(moved.stock->height_mm, 110.0, 0.01);
  EXPECT_EQ(moved_to(kept, "ring.json").parts.at(0).drawing, "parts/ring.svg");
}

}  // namespace
}  // namespace sim::sheet
