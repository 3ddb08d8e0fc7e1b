#include "host-sim/report/report.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "host-sim/report/duration_text.hpp"
#include "host-sim/report/report_json.hpp"
#include "host-sim/report/report_text.hpp"
#include "tests/host-sim/trace/scratch_file.hpp"

namespace sim {
namespace {

using nlohmann::ordered_json;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

Report bracket() {
  Report report;
  report.job = "bracket.nc";
  report.job_time_s = 83.25;
  report.path_length_mm = 2310.5;
  report.cut_length_mm = 1800.25;
  report.lines = 412;
  report.blocks = 405;
  report.axes[0] = {100.0, 1'500.0, 50'000.0, -1.0, 120.5, 19'440};
  report.axes[1] = {80.5, 1'499.5, 49'000.0, 0.0, 80.0, 12'800};
  report.axes[3] = {90.0, 45.0, 900.0, 0.0, 360.0, 3'600};
  report.max_path_deviation_mm = 0.0061;
  report.max_path_deviation_at_s = 12.5;
  return report;
}

std::vector<std::string> keys_of(const ordered_json& object) {
  std::vector<std::string> keys;
  for (const auto& [key, value] : object.items()) keys.push_back(key);
  return keys;
}

TEST(ReportJson, HasTheDocumentedKeysInOrder) {
  const ordered_json json = to_json(bracket());
  EXPECT_THAT(keys_of(json),
              ElementsAre("job",
                          "version",
                          "job_time_s",
                          "path_length_mm",
                          "cut_length_mm",
                          "lines",
                          "refused_lines",
                          "blocks",
                          "max_speed_mm_s",
                          "max_speed_mm_min",
                          "max_acceleration_mm_s2",
                          "max_jerk_mm_s3",
                          "bounds_mm",
                          "steps",
                          "max_speed_deg_s",
                          "max_speed_deg_min",
                          "max_acceleration_deg_s2",
                          "max_jerk_deg_s3",
                          "bounds_deg",
                          "measuring_error",
                          "max_path_deviation_mm",
                          "max_path_deviation_at_s",
                          "max_shaping_error_mm",
                          "energy_per_mm_ratio",
                          "warnings",
                          "faults"));
  EXPECT_THAT(keys_of(json["max_speed_mm_s"]), ElementsAre("X", "Y", "Z", "A", "B", "C"));
  EXPECT_EQ(json["max_speed_mm_min"]["X"], 6'000.0);
  EXPECT_EQ(json["bounds_mm"]["X"], ordered_json::array({-1.0, 120.5}));
  EXPECT_EQ(json["steps"]["A"], 3'600);
  EXPECT_THAT(keys_of(json["bounds_deg"]), ElementsAre("A", "B", "C"));
  EXPECT_EQ(json["bounds_deg"]["A"], json["bounds_mm"]["A"]);
  EXPECT_THAT(keys_of(json["measuring_error"]),
              ElementsAre("max_speed", "max_acceleration", "max_jerk", "bounds"));
  EXPECT_TRUE(json["faults"].is_array());
  EXPECT_THAT(keys_of(json["energy_per_mm_ratio"]), ElementsAre("least", "mean", "greatest"));
}

TEST(ReportJson, WritesOneAsAnObjectAndSeveralAsAnArray) {
  const ScratchFile file{".json"};
  const std::vector<Report> reports{bracket(), bracket()};
  write_json(file.path(), std::span{reports}.first(1));
  EXPECT_EQ(ordered_json::parse(file.text())["blocks"], 405);
  write_json(file.path(), reports);
  EXPECT_EQ(ordered_json::parse(file.text()).size(), 2U);
  write_json(file.path(), {});
  EXPECT_EQ(file.text(), "[]\n");
}

TEST(ReportJson, SurvivesWhatJsonCannotSay) {
  const ScratchFile file{".json"};
  std::vector<Report> reports{bracket()};
  reports[0].job = "\xff.nc";
  reports[0].job_time_s = std::numeric_limits<double>::quiet_NaN();
  reports[0].faults.push_back({"\xff.nc", 3, 5, 33, "arc \"end\""});
  write_json(file.path(), reports);
  const ordered_json json = ordered_json::parse(file.text());
  EXPECT_EQ(json["job"], "\uFFFD.nc");
  EXPECT_TRUE(json["job_time_s"].is_null());
  EXPECT_THAT(keys_of(json["faults"][0]),
              ElementsAre("file", "line", "column", "number", "message"));
}

TEST(ReportText, ShowsTheEnergyOfABeam) {
  Report report = bracket();
  EXPECT_THAT(report_text(report, false), Not(HasSubstr("energy")));
  report.min_energy_ratio = 0.994;
  report.mean_energy_ratio = 1.0;
  report.greatest_energy_ratio = 1.0061;
  EXPECT_THAT(report_text(report, false),
              HasSubstr("  energy/mm  0.994 to 1.006 of programmed, 1.000 on average\n"));
}

TEST(ReportText, IsReadable) {
  Report report = bracket();
  report.warnings.push_back("feed above $110");
  report.faults.push_back({"bracket.nc", 12, 5, 33, "no such arc"});
  report.faults.push_back({"bracket.nc", 13, 0, 9, "locked"});
  EXPECT_EQ(report_text(report, false),
            "bracket.nc\n"
            "  time       1 min 23.3 s\n"
            "  path       2310.5 mm, 1800.2 mm of it cut\n"
            "  program    412 lines, 405 blocks\n"
            "  deviation  0.0061 mm at 12.5 s\n"
            "\n"
            "  axis  from mm    to mm  steps    mm/s  mm/min  mm/s²  mm/s³\n"
            "  X      -1.000  120.500  19440  100.00    6000   1500  50000\n"
            "  Y       0.000   80.000  12800   80.50    4830   1500  49000\n"
            "\n"
            "  axis  from deg   to deg  steps  deg/s  deg/min  deg/s²  deg/s³\n"
            "  A        0.000  360.000   3600  90.00     5400    45.0     900\n"
            "\n"
            "warning: feed above $110\n"
            "fault: bracket.nc:12:5: no such arc\n"
            "fault: bracket.nc:13: locked\n");
}

TEST(ReportText, HasARowForEachJob) {
  Report other = bracket();
  other.job = "größe 板.nc";
  other.faults.push_back({"größe 板.nc", 1, 2, 20, "no such command"});
  const std::vector<Report> reports{bracket(), other};
  EXPECT_EQ(
      summary_text(reports, false),
      "job                  time  path mm  cut mm  lines  blocks  mm/min  mm/s²  deviation mm\n"
      "bracket.nc   1 min 23.3 s   2310.5  1800.2    412     405    6000   1500        0.0061\n"
      "größe 板.nc  1 min 23.3 s   2310.5  1800.2    412     405    6000   1500        0.0061\n"
      "\n"
      "fault: größe 板.nc:1:2: no such command\n");
}

TEST(ReportText, IsColouredOnlyWhenAsked) {
  const std::vector<Report> reports{bracket(), bracket()};
  EXPECT_THAT(report_text(reports[0], true), HasSubstr("\033[1mbracket.nc\033[0m"));
  EXPECT_THAT(summary_text(reports, true), HasSubstr("\033[1m"));
  EXPECT_THAT(report_text(reports[0], false), Not(HasSubstr("\033")));
  EXPECT_THAT(summary_text(reports, false), Not(HasSubstr("\033")));
}

TEST(ReportText, PrintsOneInFullAndSeveralAsASummary) {
  const ScratchFile file{".txt"};
  const std::vector<Report> reports{bracket(), bracket()};
  std::FILE* stream = std::fopen(file.path().c_str(), "w");
  print_table(stream, std::span{reports}.first(1), false);
  print_table(stream, reports, false);
  std::fclose(stream);
  EXPECT_EQ(file.text(), report_text(reports[0], false) + summary_text(reports, false));
}

TEST(DurationText, IsSaidAsPeopleSayIt) {
  EXPECT_EQ(duration_text(0.0), "0.0 s");
  EXPECT_EQ(duration_text(59.94), "59.9 s");
  EXPECT_EQ(duration_text(59.96), "1 min 00.0 s");
  EXPECT_EQ(duration_text(62.3), "1 min 02.3 s");
  EXPECT_EQ(duration_text(3'599.99), "1 h 00 min 00 s");
  EXPECT_EQ(duration_text(7'501.0), "2 h 05 min 01 s");
}

/// A terminal obeys DEL and C1, which JSON may contain without escapes.
TEST(ReportJson, HoldsNoByteThatATerminalObeys) {
  const std::string evil =
      "a\x1B[31m\n\x7F\xC2\x9B"
      "1mé";
  const std::string text = dumped({{"name", evil}});
  EXPECT_THAT(text, HasSubstr(R"(a\u001b[31m\n\u007f\u009b1mé)"));
  EXPECT_EQ(ordered_json::parse(text)["name"], evil);
}

}  // namespace
}  // namespace sim
