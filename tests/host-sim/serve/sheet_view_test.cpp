#include "host-sim/serve/sheet_view.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

namespace sim {
namespace {

using nlohmann::json;
using testing::HasSubstr;

constexpr const char* kSquare =
    R"(<svg xmlns="http://www.w3.org/2000/svg" width="20mm" height="20mm" viewBox="0 0 20 20">)"
    R"(<rect id="s" x="0" y="0" width="20" height="20"/></svg>)";

json placed(const json& request) { return json::parse(placed_sheet(request.dump()).content); }

json sheet_with(const json& places) {
  return {{"kerfline_sheet", 1},
          {"stock", {{"width_mm", 100}, {"height_mm", 60}}},
          {"parts", {{{"drawing", "squares/s.svg"}, {"places", places}}}}};
}

TEST(SheetView, HasTheOutlinesOfEachCopyWhereItLies) {
  const json reply = placed(
      {{"sheet",
        sheet_with({{{"x_mm", 10}, {"y_mm", 5}}, {{"x_mm", 80}, {"y_mm", 5}, {"angle_deg", 90}}})},
       {"drawings", {{"squares/s.svg", kSquare}}}});
  EXPECT_EQ(reply["faults"], json::array());
  ASSERT_EQ(reply["copies"].size(), 2U);
  for (const auto& [copy, left] : {std::pair{0U, 10.0}, std::pair{1U, 60.0}}) {
    const json& row = reply["copies"][copy];
    EXPECT_EQ(row["part"], 0);
    EXPECT_EQ(row["copy"], copy);
    ASSERT_EQ(row["outlines"].size(), 1U);
    double least = 1.0e9;
    double most = -1.0e9;
    for (std::size_t i = 0; i < row["outlines"][0].size(); i += 2) {
      least = std::min(least, row["outlines"][0][i].get<double>());
      most = std::max(most, row["outlines"][0][i].get<double>());
    }
    EXPECT_EQ(least, left);
    EXPECT_EQ(most, left + 20.0);
  }
}

TEST(SheetView, TellsWhatLiesBadly) {
  const json drawings{{"squares/s.svg", kSquare}};
  const auto fault = [&](const json& places, double distance) {
    const json reply =
        placed({{"sheet", sheet_with(places)}, {"drawings", drawings}, {"distance_mm", distance}});
    return reply["faults"].empty() ? std::string{} : reply["faults"][0].get<std::string>();
  };
  const auto pair = [](double x) {
    return json{{{"x_mm", 10}, {"y_mm", 5}}, {{"x_mm", x}, {"y_mm", 5}}};
  };
  EXPECT_EQ(fault(pair(30.3), 0.2), "");
  EXPECT_THAT(fault(pair(30.1), 0.2), HasSubstr("s #1"));
  EXPECT_THAT(fault(pair(25.0), 0.0), HasSubstr("overlap"));
  EXPECT_THAT(fault(json{{{"x_mm", 90}, {"y_mm", 5}}}, 0.0), HasSubstr("stock"));
}

/// A missing drawing is reported by its name, the other parts are placed, and the sheet is returned
/// completely.
TEST(SheetView, PlacesWhatIsHere) {
  json sheet = sheet_with({{{"x_mm", 10}, {"y_mm", 5}}});
  sheet["parts"].push_back(
      {{"drawing", "t.svg"}, {"copies", 3}, {"x_mm", 40}, {"y_mm", 5}, {"step_x_mm", 15}});
  const json reply = placed({{"sheet", sheet}, {"drawings", {{"squares/s.svg", kSquare}}}});
  ASSERT_EQ(reply["faults"].size(), 1U);
  EXPECT_THAT(reply["faults"][0].get<std::string>(), HasSubstr("t.svg is not here"));
  EXPECT_EQ(reply["copies"].size(), 1U);
  EXPECT_EQ(reply["sheet"]["parts"][1]["places"].size(), 3U);
  const json other = placed({{"sheet", sheet}, {"drawings", {{"t.svg", kSquare}}}});
  ASSERT_EQ(other["copies"].size(), 3U);
  EXPECT_EQ(other["copies"][2]["part"], 1);
  EXPECT_EQ(other["copies"][2]["copy"], 2);
}

TEST(SheetView, TellsOfRequestsThatAreNone) {
  const std::string deep = R"({"sheet":)" + std::string(1'000'000, '[');
  for (const std::string& request : {std::string{},
                                     std::string{"[]"},
                                     std::string{"{"},
                                     deep,
                                     deep + std::string(1'000'000, ']') + "}"}) {
    const json reply = json::parse(placed_sheet(request).content);
    ASSERT_EQ(reply["faults"].size(), 1U);
    EXPECT_THAT(reply["faults"][0].get<std::string>(), HasSubstr("no JSON object"));
  }
  for (const json& request : {json{{"sheet", 3}},
                              json{{"drawings", 3}},
                              json{{"sheet", {{"parts", 3}}}},
                              json::object(),
                              json{{"sheet", sheet_with(3)},
                                   {"drawings", {{"squares/s.svg", 3}}},
                                   {"distance_mm", "x"}}}) {
    EXPECT_FALSE(placed(request)["faults"].empty());
  }
}

}  // namespace
}  // namespace sim
