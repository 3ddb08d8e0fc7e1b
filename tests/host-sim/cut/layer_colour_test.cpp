#include "host-sim/cut/layer_colour.hpp"

#include <gtest/gtest.h>

#include "host-sim/cut/layer_settings.hpp"

namespace sim::cut {
namespace {

TEST(LayerColour, IsOneHoweverItIsWritten) {
  for (const char* red :
       {"red", "RED", "#f00", "#FF0000", "rgb(255,0,0)", "rgb(100%, 0%, 0%)", "ACI 1"}) {
    EXPECT_EQ(colour_from(red), 0xFF0000U) << red;
  }
  for (const char* none :
       {"", "none", "#ff00", "#12345g", "rgb(1,2)", "rgb(256,0,0)", "ACI 0", "ACI 300"}) {
    EXPECT_FALSE(colour_from(none).has_value()) << none;
  }
}

TEST(LayerColour, HasTheNamesOfThePalette) {
  EXPECT_TRUE(is_colour_named("#00F", "C01"));
  EXPECT_TRUE(is_colour_named("rgb(255,0,0)", "c02"));
  EXPECT_TRUE(is_colour_named("#00e000", "green"));
  EXPECT_TRUE(is_colour_named("#008000", "green"));
  EXPECT_TRUE(is_colour_named("#F36926", "T1"));
  EXPECT_FALSE(is_colour_named("#0000fe", "blue"));
  EXPECT_FALSE(is_colour_named("#000", "C30"));
  EXPECT_FALSE(is_colour_named("none", "none"));
}

LayerSettings settings_by(const std::vector<std::string>& texts, const drawing::Layer& layer) {
  std::vector<LayerRule> rules;
  for (const std::string& text : texts) rules.push_back(parse_rule(text, "--layer"));
  return settings_for(layer, {.passes = 3}, rules);
}

TEST(LayerRules, StarIsForLayersThatNoOtherNames) {
  const std::vector<std::string> rules{"*: feed=500", "blue: kind=engrave, power=20%"};
  EXPECT_EQ(settings_by(rules, {"a", "#f00"}).feed_mm_min, 500.0);
  EXPECT_EQ(settings_by(rules, {"a", "#f00"}).passes, 3U);
  const LayerSettings engraved = settings_by(rules, {"b", "#00f"});
  EXPECT_EQ(engraved.side, Side::kMark);
  EXPECT_FALSE(engraved.feed_mm_min.has_value());
  EXPECT_EQ(engraved.passes, 1U) << "what all cuts have is for cuts";
}

TEST(LayerRules, TellKindsOfOperationsApart) {
  EXPECT_EQ(settings_by({"a: kind=cut"}, {"a", ""}).side, Side::kWaste);
  EXPECT_TRUE(settings_by({"a: kind=score"}, {"a", ""}).is_scored);
  EXPECT_EQ(settings_by({"a: kind=fill, interval=0.2, angle=45"}, {"a", ""}).fill.angle_deg, 45.0);
  EXPECT_EQ(settings_by({"a: kind=skip"}, {"a", ""}).side, Side::kSkip);
  EXPECT_EQ(settings_by({"a: kind=image, gamma=2"}, {"a", ""}).image.gamma, 2.0);
  EXPECT_EQ(settings_by({"*: kind=cut, tabs=2"}, {"a", "image"}).side, Side::kSkip);
  for (const char* wrong : {"a: kind=photo",
                            "a: gamma=2",
                            "a: kind=image, angle=4",
                            "a: kind=image, tabs=2",
                            "a: kind=image, gamma=0",
                            "a: kind=image, min-power=101%",
                            "a: kind=engrave, tabs=2",
                            "a: interval=0.2",
                            "a: kind=engrave, angle=4",
                            "a: air=M9",
                            "a: passes=0",
                            "a: power=0%",
                            "a: power=101%",
                            "a: power=S",
                            "a: passes-by=day"}) {
    EXPECT_THROW(static_cast<void>(settings_by({wrong}, {"a", ""})), std::invalid_argument)
        << wrong;
  }
}

TEST(LayerRules, TurnSharesIntoWatts) {
  LayerSettings settings;
  set(settings, "power", "60%");
  power_in_watts(settings, 40.0, 1000.0);
  EXPECT_DOUBLE_EQ(settings.power_w.value_or(0.0), 24.0);
  set(settings, "power", "S250");
  power_in_watts(settings, 40.0, 1000.0);
  EXPECT_DOUBLE_EQ(settings.power_w.value_or(0.0), 10.0);
  set(settings, "power", "7W");
  EXPECT_DOUBLE_EQ(settings.power_w.value_or(0.0), 7.0);
  set(settings, "power", "S1001");
  EXPECT_THROW(power_in_watts(settings, 40.0, 1000.0), std::invalid_argument);
}

}  // namespace
}  // namespace sim::cut
