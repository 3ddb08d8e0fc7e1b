#include <regex>

#include "tests/firmware/controller_test.hpp"

namespace cnc {
namespace {

class StatusReportTest : public ControllerTest {
 protected:
  static std::string field(const std::string& report, const std::string& name) {
    std::smatch found;
    const bool there = std::regex_search(report, found, std::regex{"[|<]" + name + ":([^|>]*)"});
    return there ? found[1].str() : "none";
  }
};

TEST_F(StatusReportTest, ReportsWhatGrblReports) {
  EXPECT_EQ(report(), "<Idle|MPos:0.000,0.000,0.000|Bf:128,1024|FS:0,0|WCO:0.000,0.000,0.000>");
  EXPECT_EQ(report(), "<Idle|MPos:0.000,0.000,0.000|Bf:128,1024|FS:0,0|Ov:100,100,100>");
  EXPECT_EQ(report(), "<Idle|MPos:0.000,0.000,0.000|Bf:128,1024|FS:0,0>");
}

TEST_F(StatusReportTest, ReportsByThemselvesWhenAsked) {
  const auto reports_in = [&](int milliseconds) {
    link.outgoing.clear();
    run(milliseconds);
    return std::count(link.outgoing.begin(), link.outgoing.end(), '<');
  };
  stream("\x8C");
  EXPECT_EQ(reports_in(1000), 0) << "no interval is set";
  send("$481=100");
  EXPECT_EQ(reports_in(1000), 10);
  stream("\x8C");
  run(2);
  EXPECT_EQ(reports_in(1000), 0);
  stream("\xC2\x8C");
  run(2);
  EXPECT_EQ(reports_in(500), 5);
  stream("\x18");
  run(10);
  EXPECT_EQ(reports_in(500), 0) << "a reset ends it";
}

TEST_F(StatusReportTest, ReportsTheFieldsThatAreChosen) {
  send_all({"G10 L2 P1 X2", "$10=0"});
  EXPECT_EQ(report(), "<Idle|WPos:-2.000,0.000,0.000|FS:0,0|WCO:2.000,0.000,0.000>");
  send("$10=1");
  report();
  EXPECT_EQ(report(), "<Idle|MPos:0.000,0.000,0.000|FS:0,0>");
  send("$10=65");
  report();
  EXPECT_EQ(report(), "<Idle|MPos:0.000,0.000,0.000>");
  send("$10=511");
  EXPECT_EQ(field(report(), "Bf"), "128,1024");
}

// Tests masks of Grbl 1.1 and of earlier versions, whose additional bits 1.1 ignores.
TEST_F(StatusReportTest, KeepsSpeedOffsetAndOverridesForEveryValueOfGrbl) {
  for (int value = 0; value < 32; ++value) {
    send("$10=" + std::to_string(value));
    std::string reports;
    for (int count = 0; count < 25; ++count) reports += report();
    for (const char* name : {"|FS:", "|WCO:", "|Ov:"}) {
      EXPECT_NE(reports.find(name), std::string::npos) << value << ' ' << name;
    }
    EXPECT_EQ(reports.find("|Bf:") != std::string::npos, (value & 2) != 0) << value;
    EXPECT_EQ(reports.find("MPos:") != std::string::npos, (value & 1) != 0) << value;
  }
}

TEST_F(StatusReportTest, ReportsAChangeOfOffsetAtOnce) {
  report();
  report();
  send("G92 X-5");
  EXPECT_EQ(field(report(), "WCO"), "5.000,0.000,0.000");
  EXPECT_EQ(field(report(), "WCO"), "none");
}

TEST_F(StatusReportTest, ReportsAChangeOfOverridesAtOnce) {
  for (int k = 0; k < 5; ++k) report();
  stream("\x91");
  EXPECT_EQ(field(report(), "Ov"), "110,100,100");
  stream("\xC2\x96\xC2\x9A");
  EXPECT_EQ(field(report(), "Ov"), "110,50,110");
  stream("\x90\x95\x99");
  EXPECT_EQ(field(report(), "Ov"), "100,100,100");
  stream("\x92\x94\x97\x9B\x9D");
  EXPECT_EQ(field(report(), "Ov"), "89,25,89");
  stream("\x93\x9C");
  EXPECT_EQ(field(report(), "Ov"), "90,25,90");
  for (int k = 0; k < 12; ++k) stream("\x92\x9A");
  EXPECT_EQ(field(report(), "Ov"), "10,25,200");
}

TEST_F(StatusReportTest, ReportsSpindleAndCoolantWithTheOverrides) {
  send_all({"M3 S500", "M8"});
  run(20);
  EXPECT_EQ(field(report(), "A"), "SF");
  send_all({"M9", "M7", "M4"});
  run(20);
  EXPECT_EQ(field(report(), "A"), "CM");
  stream("\xA0");
  run(2);
  EXPECT_EQ(field(report(), "A"), "CFM");
  stream("\xC2\xA1");
  run(2);
  EXPECT_EQ(field(report(), "A"), "CF");
}

TEST_F(StatusReportTest, ReportsTheInputs) {
  EXPECT_EQ(field(report(), "Pn"), "none");
  port.limits.first = 0b101;
  port.probe = true;
  run(50);
  EXPECT_EQ(field(report(), "Pn"), "XZP");
}

TEST_F(StatusReportTest, ReportsLineNumbersAndSpeedWhileMoving) {
  send("N123 G1 X5 F600");
  run(200);
  const std::string moving = report();
  EXPECT_EQ(moving.substr(0, 5), "<Run|") << moving;
  EXPECT_EQ(field(moving, "Ln"), "123");
  EXPECT_EQ(field(moving, "FS"), "600,0");
}

TEST_F(StatusReportTest, ReportsInInches) {
  send_all({"$13=1", "G0 X25.4"});
  run_until_idle();
  EXPECT_EQ(field(report(), "MPos"), "1.0000,0.0000,0.0000");
}

TEST_F(StatusReportTest, ReportsAsManyAxesAsAreWantedFromTheNextResetOn) {
  send("$853=5");
  EXPECT_EQ(field(report(), "MPos"), "0.000,0.000,0.000");
  stream("\x18");
  run(20);
  EXPECT_EQ(field(report(), "MPos"), "0.000,0.000,0.000,0.000,0.000");
  EXPECT_EQ(send("$I+"), "ok");
  EXPECT_NE(link.outgoing.find("[AXS:5:XYZAB]"), std::string::npos);
}

TEST_F(StatusReportTest, ReportsEverythingWhenAsked) {
  const std::string full = report("\xC2\x87");
  for (const char* name : {"MPos", "Bf", "FS", "WCO", "Ov", "WCS", "H", "T", "TLR"}) {
    EXPECT_NE(field(full, name), "none") << name << " in " << full;
  }
  EXPECT_EQ(report("\x83"), "[GC:G0 G54 G17 G21 G90 G94 G61 M5 M9 T0 F0 S0]");
}

}  // namespace
}  // namespace cnc
