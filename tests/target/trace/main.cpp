/// The simulator's side of target.image_trace: makes a job with the bytes of each cycle, and
/// records its edges.
///
///   image_trace_jobs random SEED TURNS FOLDER
///   image_trace_jobs SETTINGS PROGRAM TURNS FOLDER
///   image_trace_jobs again LATE TURNS FOLDER
///
/// Writes to FOLDER: `settings` for a new machine, `sent` and `times` (lines TURN BYTES), and
/// `edges`. The edges are lines `TICK X Y Z COUNTS`: motor steps since power-up, and the output as
/// the count of the image's timer, at each tick at which one of them changed. Prints the number of
/// cycles that the job took.
///
/// The third form runs the job of FOLDER again, with the same bytes in the same cycles, and with
/// the main loop as late as in the file LATE: lines TURN BEHIND, which are boundaries with the
/// number of cycles that were due there and not finished.

#include <fmt/core.h>
#include <fmt/os.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <fstream>
#include <iterator>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "hal/stm32f405/boards/generic.hpp"
#include "host-sim/machine/virtual_controller.hpp"
#include "planner/gcode/decimal.hpp"
#include "tests/target/trace/random_job.hpp"
#include "tests/target/trace/repeated_sender.hpp"

namespace trace {
namespace {

/// Cycle by which the image has started, with any content of its store.
constexpr std::uint32_t kFirstTurn = 60;
constexpr std::uint32_t kPeriod = 168'000'000 / hal::stm32f405::kGeneric.power_hz;
static_assert(kPeriod <= 65535, "the timer counts clocks undivided");

class EdgeList final : public sim::TraceSink {
 public:
  explicit EdgeList(const std::string& file) : out_{fmt::output_file(file)} {}

  void on_row(const sim::TraceRow& row) override {
    constexpr std::uint32_t kFull = 65535;
    const auto duty = static_cast<std::uint32_t>(row.duty * float{kFull} + 0.5F);
    const Row now{row.position[0],
                  row.position[1],
                  row.position[2],
                  static_cast<std::int32_t>((duty * kPeriod + kFull / 2) / kFull)};
    if (now == last_) return;
    last_ = now;
    const std::uint64_t tick = row.time_ns / sim::VirtualController::kNanosecondsPerTick;
    out_.print("{} {} {} {} {}\n", tick, now[0], now[1], now[2], now[3]);
  }

 private:
  using Row = std::array<std::int32_t, 4>;

  fmt::ostream out_;
  Row last_{};
};

std::string text_of(const std::string& file) {
  std::ifstream stream{file, std::ios::binary};
  std::string text{std::istreambuf_iterator<char>{stream}, {}};
  if (text.empty()) fmt::print(stderr, "nothing in {}\n", file);
  if (!text.empty() && text.back() != '\n') text += '\n';
  return text;
}

/// Returns the `$N=value` lines of a text; skips comments and everything else.
std::string settings_in(const std::string& text) {
  std::string settings;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = text.find('\n', at);
    if (text[at] == '$') settings += text.substr(at, end + 1 - at);
    at = end + 1;
  }
  return settings;
}

/// Applies the settings with the values that the image reads, which rounds decimals in its own way.
void apply_settings(const std::string& settings, cnc::Machine& machine) {
  for (std::size_t at = 0; at < settings.size(); at = settings.find('\n', at) + 1) {
    std::uint16_t number = 0;
    const char* const end = settings.data() + settings.size();
    const auto read = std::from_chars(settings.data() + at + 1, end, number);
    const std::size_t value_at = static_cast<std::size_t>(read.ptr - settings.data()) + 1;
    const auto value = cnc::gcode::read_decimal(std::string_view{settings}.substr(value_at));
    if (!value.ok() || !machine.change_setting(number, value.value().value.to_float()).ok()) {
      fmt::print(stderr, "refused: ${}\n", number);
    }
  }
}

void write(const std::string& file, const std::string& text) {
  std::ofstream{file, std::ios::binary} << text;
}

/// Boundaries at which the main loop was late.
class LateTurns {
 public:
  explicit LateTurns(const std::string& file) {
    std::ifstream stream{file};
    std::uint32_t boundary = 0;
    for (std::uint32_t behind = 0; stream >> boundary >> behind;) behind_[boundary] = behind;
  }

  /// Returns whether a cycle was not yet finished at this boundary: a later boundary has found it
  /// missing.
  [[nodiscard]] bool still_missing(std::uint32_t turn, std::uint32_t boundary) const {
    return std::any_of(behind_.upper_bound(boundary), behind_.end(), [turn](const auto& late) {
      const std::uint32_t due = late.first - cnc::kTurnsToMotion;
      return turn <= due && turn + late.second > due;
    });
  }

 private:
  std::map<std::uint32_t, std::uint32_t> behind_;  ///< Number of late cycles by boundary.
};

std::vector<Burst> bursts_in(const std::string& file) {
  std::ifstream stream{file};
  std::vector<Burst> bursts;
  for (Burst burst; stream >> burst.turn >> burst.bytes;) bursts.push_back(burst);
  return bursts;
}

/// Records the cycle in which an alarm was raised, for the file `alarm`. An alarm ends motion and
/// beam immediately, within the millisecond of its cycle, not at a certain tick.
class AlarmWatch {
 public:
  void look(const cnc::Machine& machine, std::uint32_t turn) {
    if (!turn_ && machine.alarm() != cnc::Alarm{}) turn_ = turn;
  }
  void tell(const std::string& folder) const {
    write(folder + "/alarm", turn_ ? std::to_string(*turn_) : "");
  }

 private:
  std::optional<std::uint32_t> turn_;
};

/// Runs the job again. A cycle runs before the next boundary; a late cycle runs after the last
/// boundary that missed it.
int run_again(const LateTurns& late, std::uint32_t turns, const std::string& folder) {
  RepeatedSender sender{text_of(folder + "/sent"), bursts_in(folder + "/times")};
  sim::VirtualController controller{sender, {}};
  apply_settings(text_of(folder + "/settings"), controller.machine());
  EdgeList edges{folder + "/edges"};
  controller.add_sink(edges);
  AlarmWatch alarm;
  std::optional<std::uint32_t> taken;
  for (std::uint32_t turn = 0; turn < turns; ++turn) {
    controller.begin_turn();
    if (!taken) taken = controller.take_turn();
    for (; taken && !late.still_missing(*taken, turn); taken = controller.take_turn()) {
      sender.begin_turn(*taken);
      controller.run_turn();
      alarm.look(controller.machine(), turn);
    }
    controller.pass_turn();
  }
  controller.end();
  alarm.tell(folder);
  fmt::print("{}\n", controller.late_turns());
  return 0;
}

int run(const Job& job, std::uint32_t max_turns, const std::string& folder) {
  constexpr std::uint32_t kCalm = 40;
  TimedSender sender{job.program, job.injections};
  sim::VirtualController controller{sender, {}};
  apply_settings(job.settings, controller.machine());
  EdgeList edges{folder + "/edges"};
  controller.add_sink(edges);
  AlarmWatch alarm;
  std::uint32_t turn = 0;
  for (std::uint32_t calm = 0; turn < max_turns && calm < kCalm; ++turn) {
    if (turn >= kFirstTurn) sender.arrive_before(turn);
    controller.turn();
    alarm.look(controller.machine(), turn);
    const bool busy = !sender.finished() || !controller.machine().idle();
    calm = busy || controller.step_timer_runs() ? 0 : calm + 1;
  }
  controller.end();
  alarm.tell(folder);
  write(folder + "/settings", job.settings);
  write(folder + "/sent", sender.sent());
  std::string times;
  for (const Burst& burst : sender.bursts()) {
    times += fmt::format("{} {}\n", burst.turn, burst.bytes);
  }
  write(folder + "/times", times);
  fmt::print("{} {} {}\n", turn, sender.refused(), static_cast<int>(controller.machine().alarm()));
  return 0;
}

}  // namespace
}  // namespace trace

int main(int count, char** arguments) {
  if (count != 5) return 1;
  const std::string first = arguments[1];
  const std::string second = arguments[2];
  const auto turns = static_cast<std::uint32_t>(std::stoul(arguments[3]));
  if (first == "again") return trace::run_again(trace::LateTurns{second}, turns, arguments[4]);
  const trace::Job job = first == "random"
                             ? trace::random_job(std::stoull(second), trace::kFirstTurn)
                             : trace::Job{.settings = trace::settings_in(trace::text_of(first)),
                                          .program = trace::text_of(second),
                                          .injections = {}};
  return trace::run(job, turns, arguments[4]);
}
