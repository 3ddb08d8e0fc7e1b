#include "host-sim/machine/simulator.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "firmware/steps/turn_gate.hpp"

namespace sim {
namespace {

struct RowKeeper final : TraceSink {
  void on_row(const TraceRow& row) override { rows.push_back(row); }
  void on_end(std::uint64_t time_ns) override { ended_ns = time_ns; }
  std::vector<TraceRow> rows;
  std::uint64_t ended_ns = 0;
};

TEST(Simulator, DrivesToTheStep) {
  Simulator simulator{"G0 X10.5 Y-3.25\nG1 Z1 F600\n", {}};
  const RunResult result = simulator.run();
  EXPECT_EQ(result.final_position, (cnc::AxisArray<std::int32_t>{2625, -813, 250, 0, 0, 0}));
  EXPECT_EQ(result.lines, 2U);
  EXPECT_EQ(result.blocks, 2U);
  EXPECT_TRUE(result.refusals.empty());
}

TEST(Simulator, TakesTheTimeOfATrapezoid) {
  // 100 mm at 100 mm/s with 500 mm/s² take 100/100 + 100/500 s. M2 announces the end a cycle later;
  // otherwise the machine would wait some ms for further lines.
  Simulator simulator{"G1 X100 F6000\nM2\n", {}};
  constexpr double kToMotion = 1.0e-6 * cnc::kTurnsToMotion * cnc::kTurnUs;
  EXPECT_NEAR(simulator.run().job_time_s, kToMotion + 1.2, 0.003);
}

TEST(Simulator, HandsOutOneRowForAnInstantInOrder) {
  Simulator simulator{"M4 S500\nG1 X5 Y5 F3000\nG0 X0 Y0\n", {}};
  ASSERT_EQ(simulator.change_setting(cnc::setting::kLaserMode, 1.0F), "");
  RowKeeper keeper;
  simulator.add_sink(keeper);
  static_cast<void>(simulator.run());
  ASSERT_FALSE(keeper.rows.empty());
  for (std::size_t i = 1; i < keeper.rows.size(); ++i) {
    EXPECT_LT(keeper.rows[i - 1].time_ns, keeper.rows[i].time_ns);
  }
  EXPECT_EQ(keeper.rows.back().duty, 0.0F);
  EXPECT_GE(keeper.ended_ns, keeper.rows.back().time_ns);
}

TEST(Simulator, DwellsInVirtualTime) {
  Simulator simulator{"G4 P2.5\n", {}};
  EXPECT_NEAR(simulator.run().job_time_s, 2.5, 0.01);
}

TEST(Simulator, ResumesAPauseAndNotesIt) {
  Simulator simulator{"G0 X1\nM0\nG0 X2\n", {}};
  const RunResult result = simulator.run();
  ASSERT_EQ(result.notes.size(), 1U);
  EXPECT_EQ(result.notes[0].first, 2U);
  EXPECT_EQ(result.final_position[0], 500);
}

TEST(Simulator, StopsAtARefusedLineWithTheMotionBeforeItDone) {
  Simulator simulator{"G0 X1\nG6 X2\nG0 X3\n", {}};
  const RunResult result = simulator.run();
  ASSERT_EQ(result.refusals.size(), 1U);
  EXPECT_EQ(result.refusals[0].line, 2U);
  EXPECT_EQ(result.final_position[0], 250);
}

TEST(Simulator, ProbesThePlate) {
  Simulator simulator{"G38.2 Z-20 F120\n", {.machine = {.probe_plate_z_mm = -4.0}}};
  const RunResult result = simulator.run();
  EXPECT_EQ(result.alarm, 0);
  ASSERT_TRUE(simulator.machine().last_probe().success);
  EXPECT_EQ(simulator.machine().last_probe().place[2].nanometres(), -4'000'000);
  // Braking from 2 mm/s with 500 mm/s² takes 4 µm, plus the queued motion.
  EXPECT_LE(result.final_position[2], -1000);
  EXPECT_GE(result.final_position[2], -1015);
}

TEST(Simulator, RaisesAnAlarmWhenTheProbeMisses) {
  Simulator simulator{"G38.2 Z-1 F600\nG0 X5\n", {.machine = {.probe_plate_z_mm = -4.0}}};
  const RunResult result = simulator.run();
  EXPECT_EQ(result.alarm, 5);
  EXPECT_EQ(result.final_position[0], 0);
}

}  // namespace
}  // namespace sim
