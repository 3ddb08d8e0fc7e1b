#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "host-sim/job/job.hpp"

namespace sim {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

Report checked(const std::string& text, const std::vector<std::string>& set = {}) {
  Job job{.file = "f", .text = text};
  for (const std::string& one : set) job.settings.push_back(parse_setting(one, "--set"));
  return check(job);
}

Report simulated(const std::string& text) {
  return simulate({.file = "f", .text = text}, JobOutputs{});
}

std::vector<std::string> faults_of(const Report& report) {
  std::vector<std::string> texts;
  for (const Fault& fault : report.faults) texts.push_back(to_string(fault));
  return texts;
}

const std::string kLaser = "$32=1";

TEST(Check, TakesChecksThatFitAndNamesThoseThatDoNot) {
  const Report good = checked("N1 G21*27\nN2 G1 X5 F500*52 ; go\nN3 G1 X0*99\n");
  EXPECT_THAT(good.faults, IsEmpty());
  EXPECT_DOUBLE_EQ(good.path_length_mm, 10.0);
  const Report bad = checked("N1 G21*20\nN2 G1 X5 F500*1\nN3 G1 X2 F500\n");
  EXPECT_THAT(faults_of(bad),
              ElementsAre("f:1:7: the check does not match its line",
                          "f:2:14: the check does not match its line"));
  EXPECT_DOUBLE_EQ(bad.path_length_mm, 2.0);
  EXPECT_EQ(bad.refused_lines, 2U);
}

TEST(Check, TellsOfARateThatTheMotorDoesNotReach) {
  const std::string program = "G21 G90\nG1 X20 F6000\n";
  const std::vector<std::string> set{"$0=10", "$100=250", "$110=60000"};
  constexpr const char* kTold =
      "f: $110=60000 is 250000 steps/s; pulses of $0=10 us allow 44091, so X is driven at 10582 "
      "mm/min at most";
  EXPECT_THAT(checked(program, set).warnings, Contains(kTold));
  EXPECT_THAT(checked(program, {"$0=2.5", "$100=250", "$110=60000"}).warnings,
              Contains(HasSubstr("pulses of $0=2.5 us allow 138571,")));
  const auto of_x = Contains(HasSubstr("so X is driven"));
  EXPECT_THAT(checked(program, {"$0=10", "$100=250", "$110=10582"}).warnings, Not(of_x));
  EXPECT_THAT(checked(program, {"$0=1", "$100=250", "$110=48000"}).warnings, Not(of_x));
  EXPECT_THAT(checked(program, {"$0=1", "$100=250", "$110=48060"}).warnings,
              Contains(HasSubstr("allow 200000, so X is driven at 48000 mm/min at most")));
}

TEST(Sim, EndsAtTheFirstWrongCheck) {
  EXPECT_THAT(simulated("N0 M110*35\nN1 G21*27\nN2 G1 X5 F500*52\n").faults, IsEmpty());
  const Report report = simulated("G1 X5 F500\nN1 G21*20\nN2 G1 X50 F500*1\n");
  EXPECT_THAT(faults_of(report), ElementsAre("f:2:7: the check does not match its line"));
  EXPECT_THAT(report.warnings, Contains("f: all figures end before line 2, which is refused"));
  EXPECT_NEAR(report.path_length_mm, 5.0, 0.01);
}

TEST(Check, LeavesRefusedLinesOutOfAllFigures) {
  const Report report =
      checked("G21\nM3 S100\nG1 X5 F500\nG6 X900\nG1 X7 L3\nG1 X6 F500\nG1 X5000 Y[1]\n", {kLaser});
  EXPECT_EQ(report.refused_lines, 3U);
  EXPECT_DOUBLE_EQ(report.path_length_mm, 6.0);
  EXPECT_DOUBLE_EQ(report.cut_length_mm, 6.0);
  EXPECT_DOUBLE_EQ(report.axes[0].greatest_mm, 6.0);
  EXPECT_EQ(report.faults.size(), 3U) << "no travel is exceeded";
  EXPECT_THAT(report.warnings,
              Contains("f: bounds, length and time do not include 3 refused "
                       "lines"));
  EXPECT_THAT(checked("G0 X1\n").warnings, IsEmpty());
}

TEST(Check, RefusesWhatTheControllerRefusesAndCostsNoMoreForIt) {
  EXPECT_THAT(faults_of(checked("G2 X0 Y0 I10 P10000000 F1000\n")),
              ElementsAre(HasSubstr("f:1:14: P10000000 is greater than 65535")));
  EXPECT_THAT(faults_of(checked("G93\nG1 Y1 F.0000001\n")),
              ElementsAre("f:2:7: motion takes more than 30 days: check F"));
  EXPECT_EQ(checked("G0 X[1]\n").path_length_mm, 0.0);
}

TEST(Check, ListsAThousandFaultsAtMost) {
  std::string text;
  for (int i = 0; i < 3000; ++i) text += "G6\n";
  const Report report = checked(text);
  EXPECT_EQ(report.faults.size(), 1000U);
  EXPECT_EQ(report.refused_lines, 3000U);
  EXPECT_THAT(report.warnings,
              Contains("f: 3000 lines are refused, of which the first 1000 are listed"));
}

TEST(Check, EndsWithTheProgram) {
  const Report report = checked("G21 G90\nG1 X10 F1000\nM2\nG1 X20 F1000\nM30\n");
  EXPECT_DOUBLE_EQ(report.axes[0].greatest_mm, 10.0);
  EXPECT_THAT(report.warnings,
              ElementsAre("f:4: the program ended in line 3: nothing from here on is driven; "
                          "2 times in all"));
  EXPECT_THAT(report.faults, IsEmpty());
  const Report driven = simulated("G21 G90\nG1 X10 F1000\nM2\nG1 X20 F1000\nM30\n");
  EXPECT_NEAR(driven.axes[0].greatest_mm, 10.0, 0.01);
  EXPECT_EQ(driven.warnings, report.warnings);
}

TEST(Check, SeesTheBytesThatTheControllerGets) {
  for (const std::string text : {"\xef\xbb\xbfG21\nG90\nG1 X5 F500\n",
                                 "G21 G90\nG1\xc2\xa0 X5 F500\n",
                                 "G21\x0c\nG1 X5\x1a F500\n",
                                 "G21\n!G1 X5 F500\n"}) {
    const Report report = checked(text);
    EXPECT_THAT(report.faults, IsEmpty()) << text;
    EXPECT_EQ(report.warnings.size(), 1U) << text;
    EXPECT_DOUBLE_EQ(report.path_length_mm, 5.0) << text;
  }
  EXPECT_THAT(faults_of(checked("G1 X5\xc3\x97 F500\n")),
              ElementsAre(HasSubstr("f:1:6: byte 195")));
}

/// Heads and words of other programs' post-processors, each with the last X.
TEST(Check, ReadsWhatTheControllerTakes) {
  struct Program {
    std::string text;
    double length;
  };
  const Program programs[]{
      {"%\nG00 Z0.5\nG00 X-4.5 Y0\nG01 Z-0.4 F50\nG02 I4.5\nG00 Z0.5\nM30\n%\n",
       0.5 + 4.5 + 0.9 + 9.0 * std::numbers::pi + 0.9},
      {"G17 G90\nG0 X10\nG2 X0 Y-10 Z0 I-10 J0 K0.000 F100\n", 10.0 + 5.0 * std::numbers::pi},
      {"O0001\nN1 G21\nN2 (6MM)\nG0 X1\n", 1.0},
      {":1001\nG0 X1\n", 1.0},
      {"%1001\nG0 X1\n% end\n", 1.0},
      {"G0 G17 G40 G49 G80 G90\nG49 G0 Z10\n", 10.0},
      {"( text='" + std::string(300, '1') + "' )\nG1 X1 F500\n", 1.0},
      {"G21 G90\n/G0 X5\nN10 /G0 X7\nG0 X1\n", 1.0},
      {"G1 X1 F100\nG2 I1 Z1 F100\nI1\n",
       1.0 + std::hypot(2.0 * std::numbers::pi, 1.0) + 2.0 * std::numbers::pi},
  };
  for (const Program& program : programs) {
    const Report report = checked(program.text);
    EXPECT_THAT(report.faults, IsEmpty()) << program.text;
    EXPECT_NEAR(report.path_length_mm, program.length, 1e-6) << program.text;
  }
  EXPECT_DOUBLE_EQ(checked("/G0 X5\nN10 /G0 X7\n", {"$890=0"}).path_length_mm, 7.0);
  EXPECT_THAT(checked("G2 X10 I5 K2 F100\n").warnings,
              ElementsAre("f:1: K is not in the plane of the arc and has no effect"));
}

TEST(Check, WarnsOfPowerAndFeedsBeyondTheMachine) {
  EXPECT_THAT(
      checked("G21 G90\nM3 S5000\nG1 X10 F99999\nM5\n", {"$30=1000", "$110=12000"}).warnings,
      ElementsAre("f:2: S5000 is above $30=1000 and gives no more than that",
                  "f:3: F99999 is above $110=12000, the rate of X: driven more slowly"));
  EXPECT_THAT(checked("M3 S1000\nG1 X10 F12000\nX0\nM5\n", {"$30=1000", "$110=12000"}).warnings,
              IsEmpty());
  const std::vector<std::string> rates{"$110=6000", "$111=6000"};
  EXPECT_THAT(checked("G1 X10 Y10 F8000\n", rates).warnings, IsEmpty())
      << "each axis has its share";
  EXPECT_THAT(checked("G2 I5 F8000\n", rates).warnings, Contains(HasSubstr("f:1: F8000 is above")));
  EXPECT_EQ(checked("G1 X1 F9000\nX2\nX3 F9001\nX4\n", rates).warnings.size(), 2U);
}

TEST(Check, WarnsOfLightAtRest) {
  EXPECT_THAT(
      checked("M3 S500\nG1 X10 F1000\nG4 P0.5\nG1 X20\nM5\n", {kLaser}).warnings,
      ElementsAre("f:3: the beam is off during this dwell: under M3 nothing burns at rest"));
  const auto spot =
      Contains("f:1: M3 is on here and off again without a motion: nothing burns at rest");
  EXPECT_THAT(checked("G1 F1 M3 S10\nM5\n", {kLaser}).warnings, spot);
  EXPECT_THAT(checked("G1 F1 M3 S10\nG0 X5\nM0\n", {kLaser}).warnings, spot);
  EXPECT_THAT(checked("G1 F1 M3 S10\n", {kLaser}).warnings, spot);
  for (const char* fine : {"M3 S500\nG4 P0\nG1 X1 F100\nM5\n",
                           "M4 S500\nG4 P1\nG1 X1 F100\nM5\n",
                           "M3 S0\nG4 P1\nM5\n",
                           "M3 S5\nG1 X1 F100\nS0\nG4 P1\nM5\n"}) {
    EXPECT_THAT(checked(fine, {kLaser}).warnings, IsEmpty()) << fine;
  }
  EXPECT_THAT(checked("M3 S500\nG4 P1\nG1 X1 F100\nM5\n").warnings, IsEmpty()) << "a spindle";
}

TEST(Check, WarnsWhereSoftLimitsGuardNothing) {
  const std::vector<std::string> set{"$22=1", "$20=1"};
  EXPECT_THAT(checked("G21\nG0 X-1\nG0 X-2\n", set).warnings,
              ElementsAre(HasSubstr("f:2: soft limits ($20) guard homed axes only")));
  EXPECT_THAT(checked("G21\nG0 X-1\n", {"$22=1"}).warnings,
              Not(Contains(HasSubstr("soft limits"))));
}

}  // namespace
}  // namespace sim
