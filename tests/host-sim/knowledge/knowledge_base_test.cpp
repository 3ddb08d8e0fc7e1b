#include "host-sim/knowledge/knowledge_base.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <vector>

#include "host-sim/knowledge/experiment_csv.hpp"
#include "host-sim/knowledge/fit.hpp"
#include "tests/host-sim/trace/scratch_file.hpp"

namespace sim {
namespace {

namespace kerf = cnc::kerf;
using testing::HasSubstr;

const std::string kHeader = std::string{kExperimentHeader} + "\n";
const std::string kGood = "plate,\"laser, 1 kW\",0.1,1,1000,3000,0.5,0.4,0.1,0.005\n";

std::string fault_in(const std::string& text) {
  try {
    static_cast<void>(read_experiments(text, "cuts.csv"));
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "none";
}

TEST(ExperimentCsv, ReadsACutWithTheMeanOfItsWidths) {
  const auto cuts = read_experiments("\xEF\xBB\xBF# a comment\r\n" + kHeader + "\r\n" + kGood, "f");
  ASSERT_EQ(cuts.size(), 1U);
  EXPECT_EQ(cuts[0].laser, "laser, 1 kW");
  EXPECT_EQ(cuts[0].condition, (kerf::Condition{1000, 1'000'000, 3'000'000}));
  EXPECT_DOUBLE_EQ(cuts[0].kerf_mm(), 0.45);
  EXPECT_EQ(cuts[0].line, 4U);
}

TEST(ExperimentCsv, TakesColumnsInAnyOrder) {
  const auto cuts = read_experiments(
      "straightness_mm,material,laser,gas_pressure_mpa,power_w,thickness_mm,speed_mm_min,"
      "kerf_top_mm,kerf_bottom_mm,dross_area_mm2\n0.005,plate,l,0,1000,2,3000,0.5,0.4,0.1\n",
      "f");
  EXPECT_EQ(cuts[0].condition.thickness_um, 2000U);
  EXPECT_EQ(cuts[0].straightness_mm, 0.005);
}

TEST(ExperimentCsv, NamesFileLineColumnAndReason) {
  const auto with = [](const char* line) { return fault_in(kHeader + kGood + line); };
  EXPECT_EQ(with("plate,l,0.1,1,nan,3000,0.5,0.4,0.1,0.005\n"),
            "cuts.csv:3: column power_w: `nan` is not a number");
  EXPECT_EQ(with("plate,l,0.1,1,1000,3000,0.5x,0.4,0.1,0.005\n"),
            "cuts.csv:3: column kerf_top_mm: `0.5x` is not a number");
  EXPECT_EQ(with("plate,l,0.1,1,1000,,0.5,0.4,0.1,0.005\n"),
            "cuts.csv:3: column speed_mm_min: is empty");
  EXPECT_EQ(with("plate,l,0.1,-1,1000,3000,0.5,0.4,0.1,0.005\n"),
            "cuts.csv:3: column thickness_mm: -1 is out of range, 0.001 to 100");
  EXPECT_EQ(with("plate,l,0.1,1,1000,3000,0.5,0.4,0.1\n"),
            "cuts.csv:3: 9 fields, the header has 10");
  EXPECT_EQ(with("plate,\"l,0.1,1,1000,3000,0.5,0.4,0.1,0\n"),
            "cuts.csv:3: a quotation mark is not closed");
  EXPECT_THAT(with("a;b,l,0.1,1,1000,3000,0.5,0.4,0.1,0\n"), HasSubstr("column material: `a;b`"));
  EXPECT_THAT(fault_in("material,speed\n"), HasSubstr("cuts.csv:1: column speed: unknown"));
  EXPECT_THAT(fault_in("material,material\n"), HasSubstr("column material: occurs twice"));
  EXPECT_EQ(fault_in("material\n"), "cuts.csv:1: column laser: is missing in the header");
  EXPECT_THAT(fault_in(""), HasSubstr("cuts.csv:1: no header"));
  EXPECT_EQ(fault_in(kHeader), "cuts.csv:1: no test cut below the header");
}

TEST(Acceptance, IsThePapersAndSaysWhy) {
  Experiment cut = read_experiments(kHeader + kGood, "f")[0];
  cut.dross_area_mm2 = 0.5;
  cut.straightness_mm = 0.01;
  EXPECT_EQ(rejection_of(cut, {}), "") << "at the limits is good";
  cut.dross_area_mm2 = 0.51;
  EXPECT_EQ(rejection_of(cut, {}), "dross area 0.51 mm2 is above 0.5 mm2");
  cut.straightness_mm = 0.011;
  EXPECT_EQ(rejection_of(cut, {}),
            "dross area 0.51 mm2 is above 0.5 mm2; straightness 0.011 mm is above 0.01 mm");
  EXPECT_EQ(rejection_of(cut, {.dross_area_mm2 = 1.0, .straightness_mm = 0.02}), "");
  cut.kerf_bottom_mm = 0.0;
  EXPECT_THAT(rejection_of(cut, {1.0, 1.0}), HasSubstr("not cut through"));
}

class KnowledgeBaseTest : public testing::Test {
 protected:
  static std::vector<Experiment> two_cuts() {
    auto cuts = read_experiments(kHeader + kGood + kGood, "cuts.csv");
    cuts[1].rejection = "dross";
    return cuts;
  }
  ScratchFile file_{"knowledge.db"};
};

TEST_F(KnowledgeBaseTest, KeepsAllCutsAndWhySomeWereRejected) {
  {
    KnowledgeBase base{file_.path(), SqlFile::Mode::kCreate};
    base.add(two_cuts(), "cuts.csv", "text");
  }
  const KnowledgeBase again{file_.path(), SqlFile::Mode::kWrite};
  const auto cuts = again.cuts_of("plate");
  ASSERT_EQ(cuts.size(), 2U);
  EXPECT_TRUE(cuts[0].accepted());
  EXPECT_EQ(cuts[1].rejection, "dross");
  EXPECT_EQ(cuts[1].file, "cuts.csv");
  EXPECT_EQ(cuts[0].condition, two_cuts()[0].condition);
  EXPECT_EQ(cuts[0].kerf_mm(), two_cuts()[0].kerf_mm());
  EXPECT_EQ(cuts[0].laser, "laser, 1 kW");
}

TEST_F(KnowledgeBaseTest, CountsNoFileTwice) {
  KnowledgeBase base{file_.path(), SqlFile::Mode::kCreate};
  base.add(two_cuts(), "cuts.csv", "text");
  EXPECT_THROW(base.add(two_cuts(), "copy.csv", "text"), std::invalid_argument);
  EXPECT_EQ(base.cuts_of("plate").size(), 2U);
  base.add(two_cuts(), "more.csv", "more");
  EXPECT_EQ(base.cuts_of("plate").size(), 4U);
}

TEST_F(KnowledgeBaseTest, ReturnsARecordAsItWasSaved) {
  KnowledgeBase base{file_.path(), SqlFile::Mode::kCreate};
  const std::size_t before = base.records().size();
  MaterialRecord record = base.record_of("CSP 1N", std::nullopt);
  EXPECT_EQ(record.unit, kerf::HeatUnit::kWattMinutesPerMillimetre) << "as printed comes first";
  record.name = "plate";
  record.calibrated = true;
  record.thicknesses[2].measured = true;
  for (PowerRecord& power : record.thicknesses[2].powers) {
    power.points = {{power.speeds_um_min.least, 500'001}, {power.speeds_um_min.most, 400'001}};
  }
  base.save(record);
  base.save(record);
  EXPECT_EQ(base.records().size(), before + 1);
  const MaterialRecord found = base.record_of("plate", record.unit);
  EXPECT_EQ(found.provenance, record.provenance);
  EXPECT_TRUE(found.calibrated);
  ASSERT_EQ(found.thicknesses.size(), 4U);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(found.thicknesses[i].slope, record.thicknesses[i].slope);
    EXPECT_EQ(found.thicknesses[i].residual_sd_mm, record.thicknesses[i].residual_sd_mm);
    ASSERT_EQ(found.thicknesses[i].powers.size(), 4U);
    EXPECT_EQ(found.thicknesses[i].powers[3].points, record.thicknesses[i].powers[3].points);
  }
}

TEST_F(KnowledgeBaseTest, NamesWhatThereIsWhenAMaterialIsUnknown) {
  try {
    static_cast<void>(KnowledgeBase::shipped().record_of("steel", std::nullopt));
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_THAT(error.what(), HasSubstr("no record of `steel`; there are CSP 1N (W/(mm/min))"));
  }
}

TEST_F(KnowledgeBaseTest, RefusesOtherFiles) {
  EXPECT_THROW((KnowledgeBase{file_.path(), SqlFile::Mode::kWrite}), std::runtime_error);
  file_.write("no data base, but long enough to be looked at as one, " + std::string(2000, 'x'));
  EXPECT_THROW((KnowledgeBase{file_.path(), SqlFile::Mode::kWrite}), std::runtime_error);
}

TEST_F(KnowledgeBaseTest, RefusesANewerVersionAndNonsenseInARecord) {
  { KnowledgeBase base{file_.path(), SqlFile::Mode::kCreate}; }
  const SqlFile sql{file_.path(), SqlFile::Mode::kWrite};
  sql.run("UPDATE power SET least_speed_um_min = 0 WHERE id = 3");
  EXPECT_THROW(static_cast<void>(KnowledgeBase(file_.path(), SqlFile::Mode::kWrite).records()),
               std::invalid_argument);
  sql.run("PRAGMA user_version = 3");
  EXPECT_THROW((KnowledgeBase{file_.path(), SqlFile::Mode::kWrite}), std::runtime_error);
}

OperationRecord operation_at(std::uint32_t thickness_um, const char* source) {
  return {.kind = "cut",
          .description = "Clean",
          .thickness_um = thickness_um,
          .power_percent = 65.5,
          .speed_um_min = 600'000,
          .origin = {.on = "2026-11-30", .source = source}};
}

TEST_F(KnowledgeBaseTest, KeepsOperationsBesideAFit) {
  KnowledgeBase base{file_.path(), SqlFile::Mode::kCreate};
  base.save_operations("plate", {operation_at(3000, "a.clb"), operation_at(4000, "a.clb")});
  MaterialRecord record = base.record_of("plate", std::nullopt);
  EXPECT_FALSE(record.has_kerf());
  EXPECT_EQ(record.provenance, "not measured here: from a.clb of 2026-11-30");
  ASSERT_EQ(record.operations.size(), 2U);
  const OperationRecord& one = record.operations[0];
  EXPECT_EQ(one.description, "Clean");
  EXPECT_EQ(one.thickness_um, 3000U);
  EXPECT_EQ(one.power_percent, 65.5);
  EXPECT_EQ(one.speed_um_min, 600'000U);
  EXPECT_EQ(one.passes, std::nullopt) << "what is not known stays so";
  EXPECT_EQ(one.kerf_mm, std::nullopt);
  EXPECT_EQ(one.origin, operation_at(3000, "a.clb").origin);
  base.save_operations("plate", {operation_at(5000, "a.clb")});
  base.save_operations("plate", {operation_at(6000, "b.clb")});
  EXPECT_EQ(base.record_of("plate", std::nullopt).operations.size(), 2U) << "of each file the last";
  base.save(fit_record(std::vector{two_cuts()[0]}, {.unit = kerf::HeatUnit::kJoulesPerMillimetre}));
  record = base.record_of("plate", std::nullopt);
  EXPECT_TRUE(record.has_kerf());
  EXPECT_EQ(record.operations.size(), 2U);
}

TEST_F(KnowledgeBaseTest, SaysWhoMeasured) {
  KnowledgeBase base{file_.path(), SqlFile::Mode::kCreate};
  auto cuts = two_cuts();
  cuts[1].rejection = "";
  for (Experiment& cut : cuts) {
    cut.measured_by = "Ada";
    cut.measured_on = "2026-11-30";
  }
  base.add(cuts, "cuts.csv", "text");
  EXPECT_EQ(base.cuts_of("plate")[1].measured_by, "Ada");
  EXPECT_EQ(fit_record(base.cuts_of("plate"), {}).provenance,
            "fitted to 2 of 2 test cuts, measured by Ada on 2026-11-30");
}

TEST_F(KnowledgeBaseTest, ReadsVersion1AndMakesItVersion2WhenItWrites) {
  {
    KnowledgeBase base{file_.path(), SqlFile::Mode::kCreate};
    base.add(two_cuts(), "cuts.csv", "text");
    const SqlFile sql{file_.path(), SqlFile::Mode::kWrite};
    sql.run(
        "DROP TABLE operation; ALTER TABLE import DROP COLUMN measured_by; "
        "ALTER TABLE import DROP COLUMN measured_on; PRAGMA user_version = 1");
  }
  {
    const KnowledgeBase base{file_.path(), SqlFile::Mode::kRead};
    EXPECT_EQ(base.cuts_of("plate").size(), 2U);
    EXPECT_EQ(base.records().size(), 3U);
  }
  KnowledgeBase base{file_.path(), SqlFile::Mode::kWrite};
  EXPECT_EQ(base.cuts_of("plate").size(), 2U);
  base.save_operations("plate", {operation_at(3000, "a.clb")});
  EXPECT_EQ(base.record_of("plate", std::nullopt).operations.size(), 1U);
}

TEST(Operations, AreChosenByThicknessAndDescription) {
  OperationRecord score = operation_at(3000, "a.clb");
  score.description = "Score";
  OperationRecord any = operation_at(0, "a.clb");
  any.thickness_um.reset();
  const std::vector<OperationRecord> library{operation_at(3000, "a.clb"), score, any};
  const auto chosen = [](const auto& operations, std::uint32_t um, const char* description) {
    return choose_operation(operations, {"plate", "cut", um, description});
  };
  EXPECT_THROW(static_cast<void>(chosen(library, 3000, "")), std::invalid_argument);
  EXPECT_EQ(chosen(library, 3000, "Score")->description, "Score");
  EXPECT_EQ(chosen(library, 4000, "")->thickness_um, std::nullopt);
  EXPECT_THROW(static_cast<void>(chosen(library, 3000, "Scor")), std::invalid_argument);
  EXPECT_THROW(static_cast<void>(choose_operation({score}, {"plate", "cut", 4000, ""})),
               std::invalid_argument);
  EXPECT_EQ(choose_operation({score}, {"plate", "fill", 3000, ""}), std::nullopt);
  OperationRecord slow = operation_at(3000, "form");
  slow.origin.is_measured_here = true;
  slow.speed_um_min = 400'000;
  OperationRecord fast = slow;
  fast.speed_um_min = 500'000;
  OperationRecord strong = fast;
  strong.power_percent = 90.0;
  const auto best = choose_operation({score, slow, strong, fast}, {"plate", "cut", 3000, ""});
  EXPECT_EQ(best->speed_um_min, 500'000U);
  EXPECT_EQ(best->power_percent, 65.5) << "the least power at the fastest speed";
}

TEST(Operations, DaysAreOfTheCalendar) {
  for (const char* const day : {"2026-11-30", "2024-02-29", "0001-01-01"})
    EXPECT_TRUE(is_date(day));
  for (const char* const wrong : {"",
                                  "2026-11-31",
                                  "2023-02-29",
                                  "2026-13-01",
                                  "26-11-30",
                                  "2026/11/30",
                                  "2026-11-3 ",
                                  "2026-00-01",
                                  "-026-01-01",
                                  "2026-11-30 "}) {
    EXPECT_FALSE(is_date(wrong)) << wrong;
  }
}

TEST_F(KnowledgeBaseTest, UndoesWhatWasNotCommitted) {
  KnowledgeBase base{file_.path(), SqlFile::Mode::kCreate};
  const SqlFile sql{file_.path(), SqlFile::Mode::kWrite};
  // The second row violates a rule of the schema: the first row must not remain either.
  sql.run("CREATE UNIQUE INDEX once ON cut (line)");
  auto cuts = two_cuts();
  cuts[1].line = cuts[0].line;
  EXPECT_THROW(base.add(cuts, "cuts.csv", "text"), std::runtime_error);
  EXPECT_TRUE(base.cuts_of("plate").empty());
  cuts[1].line += 1;
  EXPECT_NO_THROW(base.add(cuts, "cuts.csv", "text")) << "nor is the file taken as added";
}

}  // namespace
}  // namespace sim
