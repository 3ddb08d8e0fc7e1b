/// Counts instructions and cycles of each stage on the emulated chip, by the model of core and
/// flash at 168 MHz of machine/, which replaces the chip's own cycle counter. The model counts only
/// on request, so that this test costs nothing.
///
/// The job is lines of 0.1 mm along a smooth curve at 12,000 mm/min with 250 steps/mm and 3000
/// mm/s², and rows of pixels of 0.1 mm and 0.01 mm.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <new>
#include <optional>
#include <string_view>
#include <tuple>

#include "firmware/application.hpp"
#include "firmware/machine/configuration.hpp"
#include "hal/interface/record_store.hpp"
#include "planner/base/contract.hpp"
#include "planner/gcode/interpreter.hpp"
#include "planner/motion/block/block_builder.hpp"
#include "planner/motion/segment/segmenter.hpp"
#include "planner/path/path_stage.hpp"
#include "tests/target/axes_text.hpp"
#include "tests/target/freeform_text.hpp"
#include "tests/target/quiet_machine.hpp"
#include "tests/target/raster_text.hpp"
#include "tests/target/start_up.hpp"

namespace {

/// Blocks of look-ahead, the same as in measurements of other controllers.
constexpr std::size_t kBlocks = 100;

/// Counts since the start: cycles, instructions, loads, branches taken, divisions, misses of the
/// flash. Differences of two counts are right beyond 2^32.
using Spent = std::array<std::uint32_t, 6>;

volatile std::uint32_t& word_of_counter(std::uint32_t number) {
  return *reinterpret_cast<volatile std::uint32_t*>(0xE0001000 + 4 * number);
}

Spent spent() {
  Spent now{};
  for (std::uint32_t i = 0; i < now.size(); ++i) now[i] = word_of_counter(1 + i);
  return now;
}

[[gnu::always_inline]] inline void count_on() { word_of_counter(0) = 1; }
[[gnu::always_inline]] inline void count_off() { word_of_counter(0) = 0; }

class Cost {
 public:
  void add(const Spent& before) {
    const Spent now = spent();
    ++times_;
    for (std::size_t i = 0; i < now.size(); ++i) {
      sums_[i] += now[i] - before[i];
      worst_[i] = std::max(worst_[i], now[i] - before[i]);
    }
  }

  /// Prints "name|unit|times" and "|sum|worst" for each count. If `times` is given, the sum is the
  /// cost of that many units together.
  void print(const char* what, const char* unit, std::uint32_t times = 0) const {
    write_text(what);
    write_text("|");
    write_text(unit);
    print_number(times > 0 ? times : times_);
    for (std::size_t i = 0; i < sums_.size(); ++i) {
      print_number(sums_[i]);
      print_number(worst_[i]);
    }
    write_text("\n");
  }

 private:
  static void print_number(std::uint64_t number) {
    std::array<char, 21> text{};
    std::size_t at = text.size() - 1;
    do {
      text[--at] = static_cast<char>('0' + number % 10);
      number /= 10;
    } while (number > 0);
    write_text("|");
    write_text(&text[at]);
  }

  std::uint32_t times_ = 0;
  std::array<std::uint64_t, std::tuple_size_v<Spent>> sums_{};
  Spent worst_{};
};

template <typename Work>
void count(Cost& cost, Work&& work) {
  const Spent before = spent();
  count_on();
  work();
  count_off();
  cost.add(before);
}

/// A sender that is never late. Its own cost is not counted.
class FreeformLink final : public hal::ByteStream {
 public:
  void send(std::string_view opening) { rest_ = opening; }
  void send_job(std::string_view opening = "G21G90G1F12000") { text_ = FreeformText{opening}; }
  void send_raster(bool is_fine = false) { raster_ = RasterText{is_fine}; }
  void send_axes(int count) { axes_ = AxesText{count}; }

  [[nodiscard]] std::size_t read(std::span<std::byte> into) override {
    count_off();
    if (rest_.empty() && !text_.finished()) rest_ = text_.next();
    if (rest_.empty() && raster_ && !raster_->finished()) rest_ = raster_->next();
    if (rest_.empty() && axes_ && !axes_->finished()) rest_ = axes_->next();
    std::size_t count = 0;
    while (count < into.size() && count < rest_.size()) {
      into[count] = static_cast<std::byte>(rest_[count]);
      ++count;
    }
    rest_.remove_prefix(count);
    count_on();
    return count;
  }

  [[nodiscard]] std::size_t write(std::span<const std::byte> from) override {
    for (const std::byte byte : from) answers += static_cast<char>(byte) == '\n' ? 1 : 0;
    return from.size();
  }

  [[nodiscard]] bool finished() const {
    return rest_.empty() && text_.finished() && (!raster_ || raster_->finished()) &&
           (!axes_ || axes_->finished());
  }

  std::uint32_t answers = 0;

 private:
  FreeformText text_{};
  std::optional<RasterText> raster_{};
  std::optional<AxesText> axes_{};
  std::string_view rest_{};
};

/// A port on which each pin access is one store.
class BarePort final : public QuietMachine {
 public:
  void set_direction(hal::AxisMask negative) noexcept { pins_ = negative.bits; }
  void raise_steps(hal::AxisMask axes, hal::AxisMask) noexcept { pins_ = axes.bits; }
  void lower_steps() noexcept { pins_ = 0; }
  void set_power(std::uint16_t duty) noexcept { duty_ = duty; }

 private:
  volatile std::uint8_t pins_ = 0;
  volatile std::uint16_t duty_ = 0;
};

class ForgetfulStore final : public hal::RecordStore {
 public:
  [[nodiscard]] std::size_t load(std::uint16_t, std::span<std::byte>) override { return 0; }
  [[nodiscard]] bool save(std::uint16_t, std::span<const std::byte>) override { return true; }
  hal::StoreWear wear() const override { return {}; }
};

BarePort port;
ForgetfulStore store;
FreeformLink link_to_job;
using Application = cnc::Controller<BarePort>;
std::uint32_t turns = 0;

/// Runs virtual time until everything sent is done, with cycles of a millisecond.
void run(Application& application, Cost& poll, Cost& interrupt) {
  constexpr std::uint32_t kTurn = cnc::motion::kTicksPerSecond / 1000;
  std::uint32_t next = 0;
  std::uint32_t now = 0;
  int quiet = 0;
  for (bool runs = false; quiet < 20; now += kTurn) {
    count(poll, [&] { application.poll(hal::TickCount{1000U * turns++}); });
    if (port.started) next = now;
    runs = runs || port.started;
    port.started = false;
    while (runs && static_cast<std::int32_t>(next - (now + kTurn)) < 0) {
      std::uint32_t wait = 0;
      count(interrupt, [&] { wait = application.on_step_interrupt(); });
      runs = wait != 0;
      next += wait;
    }
    const bool busy = runs || !link_to_job.finished() || !application.machine().idle();
    quiet = busy ? 0 : quiet + 1;
  }
}

void count_firmware(Application& application) {
  Cost unused;
  Cost lines;
  Cost turn;
  Cost interrupt;
  link_to_job.send("$100=250\n$101=250\n$110=12000\n$111=12000\n$120=3000\n$121=3000\n$C\n");
  run(application, unused, unused);
  const std::uint32_t before = link_to_job.answers;
  link_to_job.send_job();
  run(application, lines, unused);
  lines.print("read, check and answer ($C), worst: a turn", "line", FreeformText::kLines);
  link_to_job.send("$C\n");
  run(application, unused, unused);
  link_to_job.send_job();
  run(application, turn, interrupt);
  turn.print(
      "the main loop in all while the job runs, worst: a turn", "line", FreeformText::kLines);
  turn.print("the same", "turn");
  interrupt.print("step interrupt", "interrupt");
  CNC_ASSERT(link_to_job.answers - before >= 2 * FreeformText::kLines);
}

/// Counts the same lines on a machine that drives ten of them in a millisecond.
void count_fast_job(Application& application) {
  Cost unused;
  Cost turn;
  link_to_job.send("$110=60000\n$111=60000\n$120=200000\n$121=200000\nG1X100Y100F60000\n");
  run(application, unused, unused);
  link_to_job.send_job("G21G90G1F60000");
  run(application, turn, unused);
  turn.print("the main loop in all at 60 m/min", "line", FreeformText::kLines);
  turn.print("the same at 60 m/min", "turn");
}

/// Counts pixels of 0.1 mm at the same speed, each in its own line.
void count_raster(Application& application) {
  Cost unused;
  Cost lines;
  Cost turn;
  Cost interrupt;
  link_to_job.send("$32=1\n$858=0\n$C\n");
  run(application, unused, unused);
  link_to_job.send_raster();
  run(application, lines, unused);
  lines.print("raster: read, check and answer ($C), worst: a turn", "pixel", RasterText::kLines);
  link_to_job.send("$C\n");
  run(application, unused, unused);
  link_to_job.send_raster();
  run(application, turn, interrupt);
  turn.print("raster: the main loop in all, worst: a turn", "pixel", RasterText::kLines);
  interrupt.print("raster: step interrupt", "interrupt");
}

/// Counts pixels of 0.01 mm at the same speed, 20,000 in a second, many in a line.
void count_fine_raster(Application& application) {
  Cost unused;
  Cost turn;
  Cost interrupt;
  link_to_job.send("G1X0F12000S0\n");
  run(application, unused, unused);
  link_to_job.send_raster(true);
  run(application, turn, interrupt);
  turn.print("fine raster: the main loop in all, worst: a turn", "pixel", RasterText::kFinePixels);
  interrupt.print("fine raster: step interrupt", "interrupt");
}

/// Counts lines on several axes, each line with a power.
void count_axes(Application& application, int axes, const char* what) {
  Cost unused;
  Cost interrupt;
  constexpr std::string_view kSame =
      "$32=1\n$102=250\n$103=250\n$104=250\n$105=250\n$112=12000\n$113=12000\n$114=12000\n"
      "$115=12000\n$122=3000\n$123=3000\n$124=3000\n$125=3000\n";
  link_to_job.send(kSame);
  run(application, unused, unused);
  link_to_job.send_axes(axes);
  run(application, unused, interrupt);
  interrupt.print(what, "interrupt");
}

/// Measures each stage alone, one after the other on each line.
class Stages {
 public:
  explicit Stages(const cnc::motion::Limits& limits) : limits_{limits}, segmenter_{queue_, limits} {
    segmenter_.reset({});
  }

  void run() {
    FreeformText text;
    while (!text.finished()) {
      const std::string_view line = text.next();
      read(line);
      round();
    }
    stage_.flush();
    round();
    while (!segmenter_.idle()) cut();
    parse_.print("read and parse", "line");
    path_.print("round its corner", "line", FreeformText::kLines);
    build_.print("build a block", "block");
    push_.print("take it into the queue", "block");
    plan_.print("look ahead over 100 blocks", "block");
    segment_.print("cut a segment", "segment");
  }

 private:
  void read(std::string_view line) {
    using Actions = decltype(interpreter_.interpret(line));
    std::optional<Actions> actions;
    count(parse_, [&] { actions.emplace(interpreter_.interpret(line)); });
    if (!actions->ok()) return;
    for (const cnc::gcode::Action& action : actions->value()) {
      item_.request.element = {.start = place_, .end = action.end};
      item_.request.feed_mm_s = action.feed;
      place_ = action.end;
      count(path_, [&] { stage_.put(item_); });
    }
  }

  void round() {
    for (;;) {
      const cnc::path::PathPiece* piece = nullptr;
      count(path_, [&] { piece = stage_.next(); });
      if (piece == nullptr) return;
      push(*piece);
      while (queue_.full()) cut();
    }
  }

  void push(const cnc::path::PathPiece& piece) {
    count(build_, [&] { block_ = cnc::motion::build_block(piece.request, limits_).value(); });
    count(push_, [&] { queue_.push(block_, piece.joint); });
    // The controller plans a burst of blocks together; here each block is planned separately.
    count(plan_, [&] { queue_.plan(limits_, {}); });
  }

  void cut() {
    cnc::motion::Segment segment;
    count(segment_, [&] { static_cast<void>(segmenter_.next(segment)); });
  }

  const cnc::motion::Limits& limits_;
  cnc::gcode::Interpreter interpreter_{};
  cnc::Position place_{};
  cnc::path::PathItem item_{.tolerance = cnc::path::tolerance_within(0.01F, 0.002F)};
  cnc::path::PathStage stage_{limits_};
  cnc::motion::Block block_{};
  cnc::motion::BlockQueueOf<kBlocks> queue_{};
  cnc::motion::Segmenter segmenter_;
  Cost parse_{};
  Cost path_{};
  Cost build_{};
  Cost push_{};
  Cost plan_{};
  Cost segment_{};
};

// The step generator has a separate memory, as on the boards.
[[gnu::section(".ccm")]] Application::Steps steps{port};
[[gnu::section(".ccm")]] constinit cnc::motion::Pixels pixels{};

/// The main memory holds either an Application or the Stages.
constexpr std::size_t kLarger = std::max(sizeof(Application), sizeof(Stages));
alignas(std::max_align_t) std::array<std::byte, kLarger> room;

}  // namespace

void run_on_target() {
  auto* const application =
      new (room.data()) Application{steps, pixels, port, port, store, link_to_job};
  count_firmware(*application);
  count_raster(*application);
  count_fine_raster(*application);
  count_axes(*application, 3, "3 axes and power: step interrupt");
  count_axes(*application, 4, "4 axes and power: step interrupt");
  count_axes(*application, 6, "6 axes and power: step interrupt");
  count_fast_job(*application);
  static const cnc::motion::Limits limits = cnc::limits_from(application->machine().settings());
  auto* const stages = new (room.data()) Stages{limits};
  stages->run();
}
