#include "host-sim/cut/placing.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "tests/host-sim/cut/support.hpp"
#include "tests/support/random_source.hpp"
#include "tests/support/trials.hpp"

namespace sim::cut {
namespace {

constexpr const char* kPart =
    "<path d=\"M10 10H50A10 10 0 0 1 60 20V40H10Z\"/><circle cx=\"30\" cy=\"25\" r=\"6\"/>"
    "<path d=\"M70 20C80 20 80 40 90 30\"/>";

MachineProfile machine() {
  return read_machine_profile(
      R"({"kerfline_machine": 1, "bed_mm": [300, 200], "origin": "back-left"})", "m.json");
}

struct Extent {
  Place low{1.0e9, 1.0e9};
  Place high{-1.0e9, -1.0e9};
};

Extent extent_of(const drawing::Drawing& drawn) {
  Extent extent;
  for (const auto& contour : drawn.contours) {
    for (const drawing::Shape& shape : contour.shapes) {
      for (std::size_t span = 0; span < span_count(shape); ++span) {
        for (int i = 0; i <= 500; ++i) {
          const Place place = jet(shape, span, i / 500.0).place;
          extent.low = extent.low.cwiseMin(place);
          extent.high = extent.high.cwiseMax(place);
        }
      }
    }
  }
  return extent;
}

TEST(Placing, LeavesADrawingWithoutWishesAsItIs) {
  drawing::Drawing drawn = drawing::read(drawing::svg_of(kPart));
  const drawing::Drawing before = drawn;
  EXPECT_TRUE(place_drawing(drawn, {}, nullptr, 1.0).empty());
  EXPECT_EQ(extent_of(drawn).low, extent_of(before).low);
}

TEST(Placing, PutsTheBoxAtCornerCentreAndPoint) {
  const MachineProfile profile = machine();
  const auto placed = [&](const PlaceWishes& wishes) {
    drawing::Drawing drawn = drawing::read(drawing::svg_of(kPart));
    EXPECT_FALSE(place_drawing(drawn, wishes, &profile, 1.0).empty());
    return extent_of(drawn);
  };
  const Extent corner = placed({.at = PlaceAt::kCorner});
  EXPECT_NEAR(corner.low.x(), 5.0, 1.0e-2);
  EXPECT_NEAR(corner.high.y(), -5.0, 1.0e-2) << "the origin is at the back";
  const Extent centre = placed({.at = PlaceAt::kCentre});
  EXPECT_NEAR(centre.low.x() + centre.high.x(), 300.0, 1.0e-2);
  EXPECT_NEAR(centre.low.y() + centre.high.y(), -200.0, 1.0e-2);
  const Extent point =
      placed({.at = PlaceAt::kPoint, .point_mm = {7.0, -90.0}, .move_mm = {1.0, 2.0}});
  EXPECT_NEAR(point.low.x(), 8.0, 1.0e-2);
  EXPECT_NEAR(point.low.y(), -88.0, 1.0e-2);
}

TEST(Placing, NeedsAMachineForItsCentre) {
  drawing::Drawing drawn = drawing::read(drawing::svg_of(kPart));
  EXPECT_THROW(static_cast<void>(place_drawing(drawn, {.at = PlaceAt::kCentre}, nullptr, 1.0)),
               std::invalid_argument);
}

TEST(Placing, KeepsArcsAndSizesUnderAnyChange) {
  for (const std::uint64_t seed : proof::Trials{200}) {
    proof::Random random{seed};
    const drawing::Drawing before = drawing::read(drawing::svg_of(kPart));
    drawing::Drawing drawn = before;
    PlaceWishes wishes{.move_mm = {random.between(-50.0, 50.0), random.between(-50.0, 50.0)},
                       .turn_deg = random.chance(0.3) ? 90.0 : random.between(-360.0, 360.0),
                       .scale = random.magnitude(0.1, 10.0),
                       .columns = 1 + random.below(3),
                       .rows = 1 + random.below(3),
                       .gap_mm = random.between(0.0, 9.0)};
    if (random.chance(0.5)) wishes.mirror = random.chance(0.5) ? MirrorAlong::kX : MirrorAlong::kY;
    static_cast<void>(place_drawing(drawn, wishes, nullptr, 1.0));
    const std::size_t copies = wishes.columns * wishes.rows;
    ASSERT_EQ(drawn.contours.size(), copies * before.contours.size());
    for (std::size_t i = 0; i < drawn.contours.size(); ++i) {
      const drawing::DrawnContour& one = drawn.contours[i];
      const drawing::DrawnContour& other = before.contours[i % before.contours.size()];
      EXPECT_NEAR(one.length_mm, wishes.scale * other.length_mm, 2.0e-3 * one.length_mm);
      EXPECT_EQ(one.depth, other.depth);
      EXPECT_EQ(one.is_hole(), one.closed && one.area_mm2 < 0.0);
      std::vector<std::string> names = drawing::shapes_of(one);
      std::vector<std::string> same = drawing::shapes_of(other);
      std::ranges::sort(names);
      std::ranges::sort(same);
      EXPECT_EQ(names, same);
    }
    const Extent extent = extent_of(drawn);
    const Extent old = extent_of(before);
    if (copies > 1) continue;
    const Place middle = 0.5 * (extent.low + extent.high);
    if (wishes.turn_deg != 90.0) continue;
    EXPECT_NEAR(drawing::distance(middle, 0.5 * (old.low + old.high) + wishes.move_mm), 0.0, 0.1);
  }
}

TEST(Placing, MirrorsTheSideThatItNames) {
  drawing::Drawing drawn = drawing::read(drawing::svg_of("<path d=\"M10 10H20L10 40Z\"/>"));
  static_cast<void>(place_drawing(drawn, {.mirror = MirrorAlong::kX}, nullptr, 1.0));
  // The long side was at the left in the drawing.
  bool has_right_side = false;
  for (const drawing::Shape& shape : drawn.contours[0].shapes) {
    const Place from = start_of(shape);
    const Place to = end_of(shape);
    has_right_side = has_right_side || (from.x() == to.x() && from.x() == 20.0);
  }
  EXPECT_TRUE(has_right_side);
}

TEST(MachineProfile, SaysHowFarAJobLeavesTheBed) {
  const MachineProfile profile = machine();
  drawing::Drawing drawn =
      drawing::read(drawing::svg_of("<circle id=\"c\" cx=\"50\" cy=\"50\" r=\"10\"/>"));
  static_cast<void>(
      place_drawing(drawn, {.at = PlaceAt::kPoint, .point_mm = {285.0, -19.0}}, &profile, 1.0));
  const CutPlan plan = plan_of(drawn, {.lead_in = {}});
  const std::vector<drawing::Fault> faults = off_the_bed(plan, drawn, profile);
  ASSERT_EQ(faults.size(), 2U);
  // The circle of 20 mm ends at X305 and Y1, and the beam extends half a kerf beyond.
  EXPECT_THAT(faults[0].reason, testing::ContainsRegex("by 5.(299|300) mm at its right"));
  EXPECT_THAT(faults[1].reason, testing::ContainsRegex("by 1.(299|300) mm at its back"));
  EXPECT_EQ(faults[0].entity.name, "circle \"c\"");
}

TEST(MachineProfile, HasSettingsAndPower) {
  const MachineProfile profile = read_machine_profile(
      R"({"kerfline_machine": 1, "bed_mm": [300, 200], "full_power_w": 40, "s_max": 255,
          "rate_mm_min": [9000, 8000], "settings": ["$32=1"]})",
      "m.json");
  EXPECT_EQ(profile.full_power_w, 40.0);
  std::vector<std::pair<int, float>> settings;
  for (const SettingChange& change : profile.settings)
    settings.emplace_back(change.number, change.value);
  EXPECT_THAT(settings,
              testing::ElementsAre(testing::Pair(30, 255.0F),
                                   testing::Pair(110, 9000.0F),
                                   testing::Pair(111, 8000.0F),
                                   testing::Pair(130, 300.0F),
                                   testing::Pair(131, 200.0F),
                                   testing::Pair(32, 1.0F)));
}

/// A damaged file is read, or refused with its name. No other effect is allowed.
TEST(MachineProfile, SurvivesDamage) {
  const std::string whole =
      R"({"kerfline_machine": 1, "name": "a", "bed_mm": [300, 200], "origin": "centre",
          "full_power_w": 4e1, "s_max": 1000, "beam_offset_mm": [1, -2], "settings": ["$32=1"]})";
  for (const std::uint64_t seed : proof::Trials{3000}) {
    proof::Random random{seed};
    std::string text = random.chance(0.7) ? whole : whole.substr(0, random.below(whole.size()));
    for (std::size_t i = random.below(4); i > 0 && !text.empty(); --i) {
      const std::size_t at = random.below(text.size());
      if (random.chance(0.5)) {
        text[at] = static_cast<char>(random.below(256));
      } else {
        text.insert(at, std::string(1 + random.below(12), "[{\"1,:e"[random.below(8)]));
      }
    }
    try {
      EXPECT_GE(read_machine_profile(text, "m.json").bed_mm.x(), 1.0);
    } catch (const std::invalid_argument& error) {
      EXPECT_THAT(error.what(), testing::HasSubstr("m.json"));
    }
  }
}

TEST(MachineProfile, NamesWhatIsWrongWithItsPlace) {
  const auto message = [](const std::string& text) {
    try {
      static_cast<void>(read_machine_profile(text, "m.json"));
    } catch (const std::invalid_argument& error) {
      return std::string{error.what()};
    }
    return std::string{};
  };
  EXPECT_THAT(message("{\n  \"a\": }"), testing::HasSubstr("m.json:2:"));
  EXPECT_THAT(message("{}"), testing::HasSubstr("is no machine profile"));
  EXPECT_THAT(message(R"({"kerfline_machine": 1})"), testing::HasSubstr("/bed_mm: is missing"));
  EXPECT_THAT(message(R"({"kerfline_machine": 1, "bed_mm": [1]})"),
              testing::HasSubstr("m.json: /bed_mm: must be two numbers"));
  EXPECT_THAT(message(R"({"kerfline_machine": 1, "bed_mm": [300, 200], "orgin": "centre"})"),
              testing::HasSubstr("/orgin: there is no such key"));
  EXPECT_THAT(message(R"({"kerfline_machine": 1, "bed_mm": [300, 200], "settings": ["$32"]})"),
              testing::HasSubstr("/settings/0"));
}

}  // namespace
}  // namespace sim::cut
