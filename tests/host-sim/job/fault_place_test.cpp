#include "host-sim/job/fault_place.hpp"

#include <gtest/gtest.h>

#include "host-sim/job/job.hpp"

namespace sim {
namespace {

TEST(FaultPlace, IsTheFirstWordBehindTheNumberOfTheLine) {
  EXPECT_EQ(first_word("G1 X1\n  N20 X5\n", 1), 1U);
  EXPECT_EQ(first_word("G1 X1\n  N20 X5\n", 2), 7U);
  EXPECT_EQ(first_word("G1\r\n/N5G1\r\n", 2), 4U);
  EXPECT_EQ(first_word("G1\rX2", 2), 1U);
  EXPECT_EQ(first_word("G1\n", 2), 0U);
  EXPECT_EQ(first_word("G1\n", 7), 0U);
}

/// For a path that cannot be driven, the fault has its reason, motions, line and column.
TEST(FaultPlace, OfAPathBesideIsTheMotionThatCannotBeDriven) {
  Job job;
  job.file = "part.nc";
  job.text = "G21 F600\nG41.1 D4 G1 X10 Y0\nN20 X30\nY10\nX20\nY1\nG40 G1 X20 Y30\nG1 X40\n";
  for (const Report& report : {check(job), simulate(job, {})}) {
    ASSERT_EQ(report.faults.size(), 2U);
    EXPECT_EQ(to_string(report.faults[0]),
              "part.nc:3:5: since G41 or G42, element 2 (N20) leads into element 5 of line 6");
    EXPECT_EQ(report.faults[0].number, 33);
    EXPECT_EQ(report.faults[1].number, 26);
  }
}

TEST(FaultPlace, AProgramThatEndsBesideThePathEndsWithAWarning) {
  Job job;
  job.file = "part.nc";
  job.text = "G21 F600\nG41.1 D1 G1 X5 Y0\nX10\nY10\nX0\n";
  const Report report = check(job);
  EXPECT_TRUE(report.faults.empty());
  ASSERT_EQ(report.warnings.size(), 1U);
  EXPECT_NE(report.warnings[0].find("end it with G40 or M2"), std::string::npos);
}

}  // namespace
}  // namespace sim
