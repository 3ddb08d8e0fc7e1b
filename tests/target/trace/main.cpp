/// The simulator's side of target.image_trace: a job with the bytes of each turn, and its edges.
///
///   image_trace_jobs random SEED TURNS FOLDER
///   image_trace_jobs SETTINGS PROGRAM TURNS FOLDER
///
/// Writes to FOLDER: `settings` for a machine that is new, `sent` and `times` (lines TURN BYTES),
/// and `edges`: lines `TICK X Y Z COUNTS`, motor steps since power-up and the output as the
/// image's timer takes it, at each tick at which one of them changed. Prints the turns it took.

#include <fmt/core.h>
#include <fmt/os.h>

#include <array>
#include <charconv>
#include <fstream>
#include <iterator>
#include <string>

#include "hal/stm32f405/boards/generic.hpp"
#include "host-sim/machine/virtual_controller.hpp"
#include "tests/target/trace/random_job.hpp"

namespace trace {
namespace {

/// The image is up by then, whatever its store holds.
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

/// `$N=value` lines; comments and what is no setting are left out.
std::string settings_in(const std::string& text) {
  std::string settings;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = text.find('\n', at);
    if (text[at] == '$') settings += text.substr(at, end + 1 - at);
    at = end + 1;
  }
  return settings;
}

void apply(const std::string& settings, cnc::Machine& machine) {
  for (std::size_t at = 0; at < settings.size(); at = settings.find('\n', at) + 1) {
    std::uint16_t number = 0;
    const char* const end = settings.data() + settings.size();
    const auto read = std::from_chars(settings.data() + at + 1, end, number);
    float value = 0.0F;
    std::from_chars(read.ptr + 1, end, value);
    if (!machine.change_setting(number, value).ok()) fmt::print(stderr, "refused: ${}\n", number);
  }
}

void write(const std::string& file, const std::string& text) {
  std::ofstream{file, std::ios::binary} << text;
}

int run(const Job& job, std::uint32_t most_turns, const std::string& folder) {
  constexpr std::uint32_t kCalm = 40;
  TimedSender sender{job.program, job.injections};
  sim::VirtualController controller{sender, {}};
  apply(job.settings, controller.machine());
  EdgeList edges{folder + "/edges"};
  controller.add_sink(edges);
  std::uint32_t turn = 0;
  for (std::uint32_t calm = 0; turn < most_turns && calm < kCalm; ++turn) {
    if (turn >= kFirstTurn) sender.arrive_before(turn);
    controller.turn();
    const bool busy = !sender.finished() || !controller.machine().idle();
    calm = busy || controller.step_timer_runs() ? 0 : calm + 1;
  }
  controller.end();
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
  const trace::Job job = first == "random"
                             ? trace::random_job(std::stoull(second), trace::kFirstTurn)
                             : trace::Job{.settings = trace::settings_in(trace::text_of(first)),
                                          .program = trace::text_of(second),
                                          .injections = {}};
  return trace::run(job, turns, arguments[4]);
}
