// Tests that the polls which the simulator skips change nothing: the same job has the same trace,
// answers and time, whatever the sender and the operator do.

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "host-sim/machine/simulator.hpp"
#include "tests/support/hostile_program.hpp"
#include "tests/support/random_source.hpp"
#include "tests/support/trials.hpp"

namespace proof {
namespace {

using sim::AfterRefusal;
using sim::RunResult;
using sim::Simulator;
using sim::TraceRow;
using sim::TraceSink;

struct RowList final : TraceSink {
  void on_row(const TraceRow& row) override { rows.push_back(row); }
  void on_end(std::uint64_t time_ns) override { ended_ns = time_ns; }
  std::vector<TraceRow> rows;
  std::uint64_t ended_ns = 0;
};

/// Realtime bytes and statements that are inserted between lines.
constexpr std::array<std::string_view, 21> kBetween{
    "?",    "!",    "~",    "\x18", "\x83", "\x84", "\x85", "\x87", "\x8C", "\x91",
    "\x99", "\x9E", "$G\n", "$#\n", "$$\n", "$X\n", "$C\n", "$H\n", "$I\n", "$J=G91 X1 F900\n",
    "\xA3"};

/// Returns a line with a checksum as from senders for Marlin.
std::string checked(const std::string& line) {
  unsigned sum = 0;
  for (const char byte : line) sum ^= static_cast<unsigned char>(byte);
  return line + "*" + std::to_string(sum);
}

std::string random_text(Random& random, const HostileJob& job) {
  const bool is_numbered = random.chance(0.5);
  const bool is_checked = is_numbered && random.chance(0.3);
  std::string text;
  for (std::size_t i = 0; i < job.lines.size(); ++i) {
    if (random.chance(0.1)) text += kBetween[random.below(kBetween.size())];
    if (random.chance(0.03)) text += "G4 P0.2\n";
    if (random.chance(0.03)) text += random.chance(0.5) ? "M3 S300\n" : "M4 S300\n";
    if (random.chance(0.02)) text += random.chance(0.5) ? "M0\n" : "M6 T2\n\xA3";
    const std::string line =
        is_numbered ? "N" + std::to_string(i + 1) + " " + job.lines[i] : job.lines[i];
    text += (is_checked ? checked(line) : line) + "\n";
  }
  if (random.chance(0.3)) text += "M2\n";
  return text;
}

/// All observable results of a run.
struct Seen {
  std::string answers;
  std::vector<TraceRow> rows;
  std::uint64_t ended_ns = 0;
  RunResult result;
};

/// Acts as an operator at random times.
void operate(Random& random, Simulator& simulator) {
  switch (random.below(1500)) {
    case 0:
      return simulator.machine().feed_hold();
    case 1:
      return simulator.machine().safety_door();
    case 2:
      return simulator.machine().lose_link();
    case 3:
      return simulator.machine().reset();
    case 4:
      return simulator.machine().switches().toggle_single_block();
    default:
      if (random.chance(0.01)) simulator.machine().resume();
  }
}

/// Runs the job of a seed, with an operator or as check() does. @param skips whether the simulator
/// skips quiet polls
Seen run(std::uint64_t seed, bool skips) {
  Random random{seed};
  const HostileJob job{random};
  Seen seen;
  Simulator simulator{
      random_text(random, job),
      {.after_refusal = AfterRefusal::kGoOn,
       .skips_quiet_polls = skips,
       .watches_memory = !skips,
       .on_answer = [&seen](std::string_view text) { (seen.answers += text) += '\n'; }}};
  for (const auto& [number, value] : job.settings) {
    static_cast<void>(
        simulator.change_setting(static_cast<std::uint16_t>(number), static_cast<float>(value)));
  }
  if (random.chance(0.5)) {
    static_cast<void>(simulator.change_setting(cnc::setting::kLaserMode, 1.0F));
    static_cast<void>(simulator.change_setting(cnc::setting::kLinkWatchdog,
                                               static_cast<float>(50 * random.below(5))));
  }
  if (random.chance(0.5)) {
    static_cast<void>(simulator.change_setting(cnc::setting::kReportInterval, 50.0F));
  }
  RowList keeper;
  simulator.add_sink(keeper);
  const bool has_operator = random.chance(0.6);
  for (int turns = 0; turns < 4000 && !simulator.done(); ++turns) {
    if (has_operator) operate(random, simulator);
    simulator.turn();
  }
  seen.rows = std::move(keeper.rows);
  seen.result = simulator.result();
  return seen;
}

TEST(QuietPolls, ChangeNothingWhereTheyAreLeftOut) {
  const Trials trials{400};
  std::size_t moved = 0;
  for (const std::uint64_t seed : trials) {
    SCOPED_TRACE("KERFLINE_SEED=" + std::to_string(seed));
    const Seen all = run(seed, false);
    const Seen fewer = run(seed, true);
    ASSERT_EQ(all.answers, fewer.answers);
    ASSERT_EQ(all.rows.size(), fewer.rows.size());
    for (std::size_t i = 0; i < all.rows.size(); ++i) {
      ASSERT_EQ(all.rows[i].time_ns, fewer.rows[i].time_ns) << i;
      ASSERT_EQ(all.rows[i].position, fewer.rows[i].position) << i;
      ASSERT_EQ(all.rows[i].duty, fewer.rows[i].duty) << i;
    }
    EXPECT_EQ(all.result.job_time_s, fewer.result.job_time_s);
    EXPECT_EQ(all.result.notes, fewer.result.notes);
    EXPECT_EQ(all.result.blocks, fewer.result.blocks);
    moved += all.rows.size() > 1'000 ? 1 : 0;
  }
  if (trials.judges_shares()) {
    EXPECT_GE(4 * moved, trials.count());
  }
}

}  // namespace
}  // namespace proof
