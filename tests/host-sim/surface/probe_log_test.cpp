#include "host-sim/surface/probe_log.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "host-sim/surface/probe_rows.hpp"
#include "host-sim/surface/probed_points.hpp"

namespace sim::surface {
namespace {

using Eigen::Vector3d;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

ProbePlan plan_3_by_2() {
  return {.grid = {.x = {.from_mm = 0, .to_mm = 20, .count = 3},
                   .y = {.from_mm = 0, .to_mm = 10, .count = 2}},
          .depth_mm = -9.0};
}

double plane(const Eigen::Vector2d& at) { return -1.0 + 0.1 * at.x() + 0.02 * at.y(); }

/// Returns the answers for a grid that was touched at all points, in the order of the program.
std::vector<std::string> good_lines(const ProbePlan& plan) {
  std::vector<std::string> lines;
  for (std::size_t turn = 0; turn < plan.grid.size(); ++turn) {
    const Eigen::Vector2d at = plan.grid.place(plan.grid.driven(turn));
    for (std::size_t touch = 0; touch < plan.touches; ++touch) {
      lines.push_back(fmt::format("[PRB:{:.3f},{:.3f},{:.3f}:1]", at.x(), at.y(), plane(at)));
    }
  }
  return lines;
}

std::string joined(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + "\r\nok\r\n";
  return text;
}

ProbedPoints read(const std::string& text, const ProbePlan& plan = plan_3_by_2()) {
  return probed_points(read_probe_log(text), plan, "f");
}

TEST(ProbeLog, ReadsAnswersAmongAnythingElse) {
  const ProbeLog log = read_probe_log(
      "Grbl 1.1h ['$' for help]\n"
      "12:03:11.123 > G38.3 Z-9 F60\n"
      "12:03:12.250 < [PRB:1.000,2.500,-3.125:1]\r\n"
      "<Run|MPos:1.000,2.000,-3.000|FS:60,0|Pn:P>ok[PRB:1,2,3:0]\n"
      "grblHAL: [PRB:-1.5,0,+2,0.000,10.5,0:1]ok\n"
      "[MSG:PRB:1,2,3:1]\n");
  ASSERT_EQ(log.answers.size(), 3U);
  EXPECT_EQ(log.answers[0].place, Vector3d(1.0, 2.5, -3.125));
  EXPECT_TRUE(log.answers[0].is_touch);
  EXPECT_EQ(log.answers[0].line, 3U);
  EXPECT_FALSE(log.answers[1].is_touch);
  EXPECT_EQ(log.answers[2].place, Vector3d(-1.5, 0, 2));
  EXPECT_THAT(log.damaged_lines, IsEmpty());
  EXPECT_FALSE(log.offset);
}

TEST(ProbeLog, PassesOverDamagedAnswers) {
  const char* damaged[] = {"[PRB:",
                           "[PRB:]",
                           "[PRB:1,2,3]",
                           "[PRB:1,2:1]",
                           "[PRB:1,2,3:2]",
                           "[PRB:1,2,nan:1]",
                           "[PRB:1,inf,3:1]",
                           "[PRB:1,,3:1]",
                           "[PRB:1,2,3,:1]",
                           "[PRB:1,2,3:1",
                           "[PRB:1,2,3x:1]",
                           "[PRB:1e999,2,3:1]",
                           "[PRB:1,2,1e5:1]",
                           "[PRB::1]",
                           "[PRB:1,2,3,4,5,6,7,8,9:1]",
                           "[PRB:1,2,3:11]",
                           "[PRB:0x1,2,3:1]"};
  for (const char* line : damaged) {
    const ProbeLog log = read_probe_log(std::string{"ok\n"} + line + "\nok\n");
    EXPECT_THAT(log.answers, IsEmpty()) << line;
    EXPECT_THAT(log.damaged_lines, ElementsAre(2U)) << line;
  }
}

TEST(ProbeLog, TakesTheOffsetOfStatusReports) {
  const ProbeLog log = read_probe_log(
      "[G54:9,9,9]\n<Idle|MPos:0,0,0|WCO:1.000,2.000,-3.500,0.000>\n[PRB:1,1,1:1]\n"
      "<Idle|WCO:1,2,-3.5|Ov:100,100,100>\n[PRB:2,2,2:1]\n<Idle|WCO:7,7,7>\n");
  ASSERT_TRUE(log.offset);
  EXPECT_EQ(*log.offset, Vector3d(1.0, 2.0, -3.5));
  EXPECT_EQ(log.changed_line, 0U) << "it changes behind the answers";
}

TEST(ProbeLog, SeesAnOffsetThatChanges) {
  const ProbeLog log = read_probe_log(
      "<Idle|WCO:0,0,0>\n<Idle|WCO:1,2,3>\n[PRB:1,1,1:1]\n<Idle|WCO:1,2,4>\n[PRB:2,2,2:1]\n");
  EXPECT_EQ(*log.offset, Vector3d(1, 2, 3));
  EXPECT_EQ(log.changed_line, 4U);
}

TEST(ProbeLog, TakesTheOffsetOfAListing) {
  const std::string listing =
      "[G54:1,2,3]\n[G55:10,20,30]\n[G59.3:5,5,5]\n[G28:8,8,8]\n[G92:0.5,0,0]\n[TLO:-2.000]\n";
  EXPECT_EQ(*read_probe_log(listing).offset, Vector3d(1.5, 2, 1));
  EXPECT_EQ(*read_probe_log(listing + "[GC:G0 G55 G17 G21 G5.1]\n").offset, Vector3d(10.5, 20, 28));
  EXPECT_EQ(*read_probe_log("[TLO:1,2,3]\n[G54:0,0,0,0]\n").offset, Vector3d(1, 2, 3));
  EXPECT_FALSE(read_probe_log("[GC:G0 G56]\n[G54:1,2,3]\n").offset);
  EXPECT_EQ(*read_probe_log("[G54:1,2,3]\n", 25.4).offset, Vector3d(25.4, 50.8, 3 * 25.4));
}

TEST(ProbedPoints, BuildsRowsInOneDirection) {
  ProbePlan plan = plan_3_by_2();
  const ProbedPoints probed = read(joined(good_lines(plan)));
  EXPECT_THAT(probed.faults, IsEmpty());
  EXPECT_THAT(probed.notes, IsEmpty());
  ASSERT_EQ(probed.points.size(), 6U);
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_EQ(probed.points[i].head<2>(), plan.grid.place(i));
    EXPECT_NEAR(probed.points[i].z(), plane(plan.grid.place(i)), 1e-9);
  }
  EXPECT_THAT(text_of_probe_rows(plan.grid, probed.points, {"a", "b"}),
              testing::StartsWith("# a\n# b\n0.000000 0.000000 -1.000000\n"));
}

TEST(ProbedPoints, NamesPointsThatLack) {
  std::vector<std::string> lines = good_lines(plan_3_by_2());
  lines[1] = "[PRB:10.000,0.000,-9.000:0]";  // The probe did not touch.
  lines[3] = "[PRB:20.000,9.0";              // The line is cut off.
  lines[5] = "[PRB:0.600,10.000,0.000:1]";   // The position is not that of the point.
  const ProbedPoints probed = read(joined(lines));
  EXPECT_THAT(
      probed.faults,
      ElementsAre("f:3: row 1, column 2 (X 10, Y 0) touched nothing down to Z -9.000; probe deeper",
                  "f: row 2, column 3 (X 20, Y 10) has no answer; probe it again",
                  "f: row 2, column 1 (X 0, Y 10) has no answer; probe it again"));
  EXPECT_THAT(probed.notes,
              ElementsAre("f:7: an answer is damaged and ignored",
                          HasSubstr("f:11: the tip touched at X 0.600, Y 10.000, Z 0.000, 0.600 mm "
                                    "away from the nearest point, row 2, column 1")));
  EXPECT_TRUE(std::isnan(probed.points[1].z()));
  EXPECT_EQ(probed.points[1].x(), 10.0);
}

TEST(ProbedPoints, TakesALostAnswerForNoOther) {
  for (std::size_t lost = 0; lost < 6; ++lost) {
    std::vector<std::string> lines = good_lines(plan_3_by_2());
    lines.erase(lines.begin() + static_cast<std::ptrdiff_t>(lost));
    const ProbedPoints probed = read(joined(lines));
    EXPECT_EQ(probed.faults.size(), 1U);
    for (std::size_t i = 0; i < 6; ++i) {
      const Eigen::Vector2d at = plan_3_by_2().grid.place(i);
      if (std::isnan(probed.points[i].z())) continue;
      EXPECT_NEAR(probed.points[i].z(), plane(at), 1e-9);
    }
  }
}

TEST(ProbedPoints, TakesTheLastOfTwoTouchesAndNoFastOneAlone) {
  ProbePlan plan = plan_3_by_2();
  plan.touches = 2;
  std::vector<std::string> lines = good_lines(plan);
  lines[0] = "[PRB:0.000,0.000,-1.300:1]";
  EXPECT_THAT(read(joined(lines), plan).faults, IsEmpty());
  EXPECT_NEAR(read(joined(lines), plan).points[0].z(), -1.0, 1e-9);
  lines.erase(lines.begin() + 2);
  EXPECT_THAT(read(joined(lines), plan).faults,
              ElementsAre(HasSubstr("row 1, column 2 (X 10, Y 0) has only its fast touch")));
}

TEST(ProbedPoints, NotesPointsThatAreProbedTwice) {
  std::vector<std::string> lines = good_lines(plan_3_by_2());
  lines.push_back("[PRB:10.000,0.000,0.500:1]");
  lines.push_back("[PRB:20.000,0.000,-9.000:0]");
  const ProbedPoints probed = read(joined(lines));
  EXPECT_THAT(probed.faults, IsEmpty());
  EXPECT_THAT(
      probed.notes,
      ElementsAre("f:13: row 1, column 2 (X 10, Y 0) is probed again: Z 0.500, and 0.000 in line 3",
                  HasSubstr("row 1, column 3 (X 20, Y 0) is probed again")));
  EXPECT_EQ(probed.points[1].z(), 0.5) << "the later height";
  EXPECT_NEAR(probed.points[2].z(), 1.0, 1e-9) << "a height, not a later miss";
}

TEST(ProbedPoints, TakesAListingOfTheLastAnswerForNoSecondOne) {
  std::vector<std::string> lines = good_lines(plan_3_by_2());
  lines.insert(lines.begin() + 2, lines[1]);
  // The answer to `$#` comes before all others.
  lines.insert(lines.begin(), "[PRB:0.000,0.000,0.000:0]");
  const ProbedPoints probed = read(joined(lines));
  EXPECT_THAT(probed.faults, IsEmpty());
  EXPECT_THAT(probed.notes, IsEmpty());
}

TEST(ProbedPoints, PassesOverGuardedWays) {
  ProbePlan plan = plan_3_by_2();
  plan.has_guards = true;
  std::string text;
  for (const std::string& line : good_lines(plan)) {
    std::string guard = line;
    guard.replace(guard.rfind(":1]"), 3, ":0]");
    text += guard + "\n" + line + "\n";
  }
  EXPECT_THAT(read(text, plan).faults, IsEmpty());
  EXPECT_THAT(read(text, plan).notes, IsEmpty());
}

TEST(ProbedPoints, ConvertsToWorkCoordinates) {
  ProbePlan plan = plan_3_by_2();
  plan.offset = {100, -50, 7};
  std::string text;
  for (std::size_t i = 0; i < 6; ++i) {
    const Eigen::Vector2d at = plan.grid.place(i);
    text += fmt::format("[PRB:{},{},{}:1]\n", at.x() + 100, at.y() - 50, plane(at) + 7);
  }
  const ProbedPoints probed = read(text, plan);
  EXPECT_THAT(probed.faults, IsEmpty());
  EXPECT_NEAR(probed.points[5].z(), plane({20, 10}), 1e-9);
  try {
    static_cast<void>(read(text));
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_THAT(error.what(), HasSubstr("f:1: no answer is at a point of the grid"));
    EXPECT_THAT(error.what(), HasSubstr("--offset"));
  }
  EXPECT_THROW(static_cast<void>(read("ok\nok\n")), std::invalid_argument);
}

TEST(ProbedPoints, ReadsAHundredThousandAnswers) {
  const ProbePlan plan{.grid = {.x = {.from_mm = 0, .to_mm = 100, .count = 400},
                                .y = {.from_mm = 0, .to_mm = 100, .count = 250}},
                       .depth_mm = -9.0};
  const ProbedPoints probed = read(joined(good_lines(plan)), plan);
  EXPECT_THAT(probed.faults, IsEmpty());
  EXPECT_EQ(probed.points.size(), 100'000U);
}

// Any bytes must give a refusal, or a grid with a height or a fault for each point.
TEST(ProbedPoints, TakesAnyLog) {
  std::mt19937_64 random{7};
  const std::string good = joined(good_lines(plan_3_by_2()));
  const std::string letters = "[PRB:1,-.]0\n<WCO|>G54eE+nai\r\0 ";
  for (int trial = 0; trial < 3000; ++trial) {
    std::string text = good;
    const std::size_t changes = random() % 30;
    for (std::size_t i = 0; i < changes; ++i) {
      const std::size_t at = random() % text.size();
      if (random() % 3 == 0) {
        text.erase(at, random() % 9);
      } else {
        text[at] = letters[random() % letters.size()];
      }
      if (text.empty()) text = "x";
    }
    try {
      const ProbedPoints probed = read(text);
      std::size_t lacking = 0;
      for (const Vector3d& point : probed.points) {
        EXPECT_TRUE(point.head<2>().allFinite());
        EXPECT_FALSE(std::isinf(point.z()));
        if (std::isnan(point.z())) ++lacking;
      }
      EXPECT_EQ(lacking, probed.faults.size());
    } catch (const std::invalid_argument&) {
    }
  }
}

}  // namespace
}  // namespace sim::surface
