#include "host-sim/sheet/sheet_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/host-sim/sheet/support.hpp"
#include "tests/support/random_source.hpp"
#include "tests/support/trials.hpp"

namespace sim::sheet {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

std::vector<std::string> faults_in(const std::string& text) {
  return texts_of(read_sheet("test.json", text).faults);
}

TEST(SheetFile, ListsPartsWithPlacesOrAsAGrid) {
  const Sheet sheet = read_sheet("test.json",
                                 sheet_with(R"(
      {"drawing": "a/bracket.svg", "places": [{"x_mm": 5},
       {"y_mm": 7, "angle_deg": -90, "mirror": true}]},
      {"drawing": "ring.dxf", "name": "washer", "copies": 5, "x_mm": 1, "y_mm": 2, "step_x_mm": 10,
       "step_y_mm": 20, "columns": 2})",
                                            R"(, "locked": true)"));
  EXPECT_THAT(texts_of(sheet.faults), IsEmpty());
  EXPECT_TRUE(sheet.locked);
  ASSERT_THAT(sheet.parts, SizeIs(2));
  EXPECT_EQ(sheet.parts[0].name, "bracket");
  EXPECT_THAT(sheet.parts[0].places,
              ElementsAre(Placing{{5.0, 0.0}}, Placing{{0.0, 7.0}, -90.0, true}));
  EXPECT_THAT(sheet.parts[1].places,
              ElementsAre(Placing{{1.0, 2.0}},
                          Placing{{11.0, 2.0}},
                          Placing{{1.0, 22.0}},
                          Placing{{11.0, 22.0}},
                          Placing{{1.0, 42.0}}));
}

TEST(SheetFile, EveryFaultNamesItsPlaceReasonAndRemedy) {
  const std::string part = R"("drawing": "a.svg")";
  const auto one = [&part](const std::string& more) {
    return faults_in(sheet_with("{" + part + "," + more + "}"));
  };
  EXPECT_THAT(one(R"("copies": -2)"),
              ElementsAre("test.json: /parts/0/copies: -2 is out of range; write 1 to 100000"));
  EXPECT_THAT(one(R"("copies": 0)"), ElementsAre(HasSubstr("/parts/0/copies: 0 is out of range")));
  EXPECT_THAT(one(R"("copies": 1.5)"), ElementsAre(HasSubstr("1.5 is no whole number")));
  EXPECT_THAT(one(R"("copies": "two")"), ElementsAre(HasSubstr("\"two\" is no number")));
  EXPECT_THAT(one(R"("mirror": 1)"),
              ElementsAre(HasSubstr("/parts/0/mirror: 1 is no true or false")));
  EXPECT_THAT(one(R"("angle_deg": 400)"), ElementsAre(HasSubstr("-360 to 360 degrees")));
  EXPECT_THAT(one(R"("x_mm": 1e300)"), ElementsAre(HasSubstr("-1000000 to 1000000 mm")));
  EXPECT_THAT(one(R"("copeis": 2)"), ElementsAre(HasSubstr("did you mean copies?")));
  EXPECT_THAT(one(R"("name": "")"), ElementsAre(HasSubstr("/parts/0/name: \"\" is no text")));
  EXPECT_THAT(one(R"("copies": 3, "places": [{}])"),
              ElementsAre(HasSubstr("3 copies, but 1 places")));
  EXPECT_THAT(one(R"("places": [])"), ElementsAre(HasSubstr("/parts/0/places: is empty")));
  EXPECT_THAT(one(R"("places": [7])"), ElementsAre(HasSubstr("/parts/0/places/0: is no place")));
  EXPECT_THAT(one(R"("places": [{"x": 7}])"),
              ElementsAre(HasSubstr("/parts/0/places/0/x: there is no such")));
  EXPECT_THAT(one(R"("places": [{}], "x_mm": 1)"),
              ElementsAre(HasSubstr("is used together with \"places\"")));
  EXPECT_THAT(one(R"("copies": 2)"), ElementsAre(HasSubstr("/parts/0/step_x_mm: copies in a row")));
  EXPECT_THAT(one(R"("copies": 2, "columns": 1, "step_x_mm": 4)"),
              ElementsAre(HasSubstr("/parts/0/step_y_mm: rows need")));
  EXPECT_THAT(faults_in(sheet_with("{}")), ElementsAre(HasSubstr("/parts/0/drawing: is missing")));
  EXPECT_THAT(faults_in(sheet_with("3")), ElementsAre(HasSubstr("/parts/0: is no part")));
  EXPECT_THAT(faults_in(sheet_with("")), ElementsAre(HasSubstr("/parts: there is no part")));
  EXPECT_THAT(faults_in(sheet_with("{" + part + "},{" + part + "}")),
              ElementsAre(HasSubstr("/parts/1/name: there is another part \"a\"")));
  EXPECT_THAT(
      faults_in(sheet_with(
          "{" + part + R"(,"copies":99999,"step_x_mm":1},{"name":"b","copies":9,"step_x_mm":1,)" +
          part + "}")),
      ElementsAre(HasSubstr("there are 100008 copies up to here; place at most 100000")));
  std::string many = "{}";
  for (std::size_t i = 0; i < kMaxParts; ++i) many += ",{}";
  EXPECT_THAT(faults_in(sheet_with(many)), ElementsAre(HasSubstr("there are 10001 parts")));
}

TEST(SheetFile, StockHasASizeAndAMarginThatLeavesRoom) {
  const auto with = [](const std::string& stock) {
    return faults_in(R"({"kerfline_sheet": 1, "stock": )" + stock +
                     R"(, "parts": [{"drawing": "a"}]})");
  };
  EXPECT_THAT(with(R"({"width_mm": 3, "height_mm": 4, "margin_mm": 1.5, "skeleton": true})"),
              IsEmpty());
  EXPECT_THAT(with(R"({"width_mm": 3, "height_mm": 4, "margin_mm": 2})"),
              ElementsAre(HasSubstr("/stock/margin_mm: 2 is out of range; write 0 to 1.5 mm")));
  EXPECT_THAT(with(R"({"width_mm": 3})"), ElementsAre(HasSubstr("/stock/height_mm: is missing")));
  EXPECT_THAT(with(R"({"width_mm": -3, "height_mm": 4})"),
              ElementsAre(HasSubstr("0.1 to 100000 mm")));
  EXPECT_THAT(with("[1, 2]"), ElementsAre(HasSubstr("/stock: [1,2] is no group")));
  EXPECT_THAT(faults_in(R"({"kerfline_sheet": 1, "parts": [{"drawing": "a"}]})"),
              ElementsAre(HasSubstr("/stock: is missing")));
  EXPECT_THAT(faults_in(R"({"kerfline_sheet": 2, "stock": {"width_mm": 3, "height_mm": 4},
                            "parts": [{"drawing": "a"}]})"),
              ElementsAre(HasSubstr("/kerfline_sheet: 2 is out of range")));
}

TEST(SheetFile, BrokenJsonIsToldByLineAndColumn) {
  EXPECT_THAT(faults_in("{\"kerfline_sheet\": 1,\n \"parts\" [\n]}"),
              ElementsAre("test.json:2:10: broken JSON; mend it here, or just before"));
  EXPECT_THAT(faults_in(R"({"kerfline_sheet": 1, "parts": [], "parts": []})"),
              ElementsAre(HasSubstr("the key \"parts\" occurs twice")));
  EXPECT_THAT(faults_in(R"({"kerfline_sheet": 1e999})"),
              ElementsAre(HasSubstr("a number is too great")));
  EXPECT_THAT(faults_in(R"({"kerfline_sheet": [[[[[[[[[1]]]]]]]]]})"),
              ElementsAre(HasSubstr("nested too deeply")));
  EXPECT_THAT(faults_in(R"([{"kerfline_sheet": 1}])"), ElementsAre(HasSubstr("no object with")));
}

TEST(SheetFile, IsToldFromOtherJson) {
  EXPECT_TRUE(is_sheet("\xEF\xBB\xBF \n{\"kerfline_sheet\": 1}"));
  EXPECT_FALSE(is_sheet(R"({"items": []})"));
  EXPECT_FALSE(is_sheet(R"([{"kerfline_sheet": 1}])"));
  EXPECT_FALSE(is_sheet("<svg id=\"kerfline_sheet\"/>"));
  EXPECT_FALSE(is_sheet(""));
  const drawing::Drawing drawn = drawing::read(sheet_with(R"({"drawing": "a"})"));
  EXPECT_THAT(texts_of(drawn.faults), ElementsAre(HasSubstr("`kerfline cut` takes sheets")));
}

TEST(SheetFile, WhatIsWrittenReadsBackToTheSameNumbers) {
  for (const std::uint64_t seed : proof::Trials{300}) {
    proof::Random random{seed};
    Sheet sheet{.file = "test.json",
                .stock = Stock{.width_mm = random.between(1.0, 1.0e4),
                               .height_mm = random.between(1.0, 1.0e4),
                               .margin_mm = random.between(0.0, 0.5),
                               .keeps_skeleton = random.chance(0.5)},
                .parts = {},
                .locked = random.chance(0.5)};
    for (int i = 0; i < 5; ++i) {
      SheetPart& part = sheet.parts.emplace_back(
          SheetPart{.name = fmt::format("p\"{}\u00fc", i), .drawing = "a b.svg", .places = {}});
      for (int k = 0; k < 4; ++k) {
        part.places.push_back({{random.between(-1.0e6, 1.0e6), random.between(-1.0, 1.0)},
                               random.between(-360.0, 360.0),
                               random.chance(0.5)});
      }
    }
    const Sheet read = read_sheet("test.json", text_of(sheet));
    ASSERT_THAT(texts_of(read.faults), IsEmpty());
    EXPECT_EQ(text_of(read), text_of(sheet));
    ASSERT_THAT(read.parts, SizeIs(5));
    for (std::size_t i = 0; i < 5; ++i) EXPECT_EQ(read.parts[i].places, sheet.parts[i].places);
  }
}

}  // namespace
}  // namespace sim::sheet
