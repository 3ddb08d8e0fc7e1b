#include "host-sim/pocket/mill_program.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

#include "host-sim/pocket/path_rows.hpp"

namespace sim::pocket {
namespace {

using cnc::pocket::Use;
using Rows = PathRows;

MillSettings mill() { return {.feed_mm_min = 600.0, .plunge_mm_min = 100.0}; }

std::string written(const Rows& rows, const MillSettings& settings) {
  return program_of(rows.path(), settings, cnc::gcode::PrintGrid{3}, {"a (pocket)"});
}

TEST(MillProgram, DrivesRowsBetweenRapidsAtTheSafeHeight) {
  const Rows rows{{{.x = 1.0, .y = 2.0, .z = -1.0},
                   {.x = 5.0, .y = 2.0, .z = -1.0, .bulge = 1.0},
                   {.x = 5.0, .y = 6.0, .z = -1.0},
                   {.x = 0.0, .y = 0.0, .z = -2.0},
                   {.x = 0.0, .y = 1.0, .z = -2.0}},
                  {3, 5}};
  EXPECT_EQ(written(rows, mill()),
            "(a _pocket_)\nG21 G90 G17 G94 G54\nG0 Z5\n"
            "G0Z5\nX1Y2\nZ0\nG1Z-1F100\nX5F600\nG3Y6J2\nG0Z5\n"
            "X0Y0\nZ-1\nG1Z-2F100\nY1F600\nG0Z5\n"
            "M2\n");
}

TEST(MillProgram, SwitchesSpindleAndCoolantOnAndOff) {
  MillSettings settings = mill();
  settings.spindle_rpm = 12'000.0;
  settings.spin_up_s = 1.5;
  settings.coolant = Coolant::kMist;
  EXPECT_EQ(written({}, settings),
            "(a _pocket_)\nG21 G90 G17 G94 G54\nG0 Z5\nS12000 M3\nG4 P1.5\nM7\nM9\nM5\nM2\n");
  settings.turns_left = true;
  settings.coolant = Coolant::kFlood;
  EXPECT_NE(written({}, settings).find("S12000 M4\nG4 P1.5\nM8\n"), std::string::npos);
}

TEST(MillProgram, DescendsNoFasterThanAPlunge) {
  // The first path is half a turn of radius 2 that descends by its own length, the second a flat
  // ramp.
  const double length = 2.0 * 3.14159265358979;
  const Rows rows{{{.z = 0.0, .bulge = 1.0, .use = Use::kEntry},
                   {.x = 4.0, .z = -length, .use = Use::kEntry},
                   {.x = 104.0, .z = -length - 1.0},
                   {.x = 104.0, .y = 1.0, .z = 0.0}},
                  {4}};
  const std::string text = written(rows, mill());
  EXPECT_NE(text.find("G3X4Z-6.283I2F141.421\n"), std::string::npos) << text;
  EXPECT_NE(text.find("G1X104Z-7.283F600\n"), std::string::npos) << text;
  EXPECT_NE(text.find("Y1Z0\n"), std::string::npos) << text;
}

TEST(MillProgram, FeedsLightPassesAtTheirOwnFeed) {
  MillSettings settings = mill();
  const Rows rows{{{.z = -1.0},
                   {.x = 1.0, .z = -1.0, .use = Use::kLight},
                   {.x = 2.0, .z = -1.0, .use = Use::kLink},
                   {.x = 3.0, .z = -1.0}},
                  {4}};
  EXPECT_EQ(written(rows, settings).find("F900"), std::string::npos);
  settings.light_feed_mm_min = 900.0;
  const std::string text = written(rows, settings);
  EXPECT_NE(text.find("X1F600\nX2F900\nX3F600\n"), std::string::npos) << text;
}

TEST(MillProgram, ReturnsInRapidsThatKeepTheirDistanceFromCuts) {
  const Rows rows{{{.z = -1.0, .use = Use::kReturn},
                   {.x = 10.0, .z = -1.0},
                   {.x = 12.0, .z = -1.0, .use = Use::kReturn},
                   {.x = 12.0, .y = 2.9, .z = -1.0, .use = Use::kReturn},
                   {.x = 12.0, .y = 12.9, .z = -2.0}},
                  {5}};
  const std::string text = written(rows, mill());
  // The short link and the link that descends are driven at the feed.
  EXPECT_NE(text.find("G1Z-1F100\nX1F600\nG0X9\nG1X10\nX12\nY2.9\nY12.9Z-2\n"), std::string::npos)
      << text;
}

TEST(MillProgram, CompensatesTheWearOfTheToolBetweenLeads) {
  const Rows rows{{{.z = -1.0, .use = Use::kLeadIn},
                   {.x = 2.0, .z = -1.0},
                   {.x = 9.0, .z = -1.0, .use = Use::kLeadOut},
                   {.x = 11.0, .z = -1.0}},
                  {4}};
  MillSettings settings = mill();
  EXPECT_EQ(written(rows, settings).find("G4"), std::string::npos);
  settings.wear_tool = 3;
  EXPECT_NE(written(rows, settings).find("F100\nG41 D3\nX2F600\nX9\nG40\nX11\nG0Z5\n"),
            std::string::npos)
      << written(rows, settings);
  settings.wears_to_left = false;
  EXPECT_NE(written(rows, settings).find("G42 D3\n"), std::string::npos);
}

TEST(MillProgram, MakesLinesOfArcsWhoseCentreIsOutOfReach) {
  const Rows rows{{{.z = -1.0, .bulge = 4.0e-5}, {.x = 1000.0, .z = -2.0}}, {2}};
  const std::string text = written(rows, mill());
  EXPECT_NE(text.find("X1000Y0Z-2\n"), std::string::npos) << text;
  EXPECT_EQ(text.find("G3"), std::string::npos) << text;
  EXPECT_GT(std::ranges::count(text, '\n'), 12) << text;
}

TEST(MillProgram, RefusesWhatNoProgramCanSay) {
  const Rows far{{{.x = 1.0e6}, {.x = 1.0}}, {2}};
  EXPECT_THROW(static_cast<void>(written(far, mill())), std::invalid_argument);
  const Rows deep{{{.z = -1.0e6}, {.x = 1.0}}, {2}};
  EXPECT_THROW(static_cast<void>(written(deep, mill())), std::invalid_argument);
}

}  // namespace
}  // namespace sim::pocket
