/// Measures lines per second on the host, stage by stage, and the ratio of simulated time to real
/// time.
/// Run: build/release/tests/bench_stages

#include <benchmark/benchmark.h>

#include <limits>
#include <string_view>
#include <vector>

#include "firmware/link/line_assembler.hpp"
#include "firmware/machine/configuration.hpp"
#include "firmware/steps/step_generator.hpp"
#include "hal/host/recording_port.hpp"
#include "host-sim/machine/simulator.hpp"
#include "planner/gcode/interpreter.hpp"
#include "planner/pipeline/action_elements.hpp"
#include "planner/pipeline/path_tolerance.hpp"
#include "planner/pipeline/pipeline.hpp"
#include "tests/support/bench_jobs.hpp"
#include "tests/support/let_in.hpp"

namespace {

using namespace cnc;

struct Job {
  std::string text;
  std::vector<std::string_view> lines;
  std::vector<path::PathItem> items;
  std::vector<path::PathPiece> pieces;  ///< Output of the path stage.
  std::vector<motion::Segment> segments;
};

const motion::Limits& limits() {
  static const motion::Limits kLimits = limits_from(Settings{});
  return kLimits;
}

void split_lines(Job& job) {
  std::string_view rest = job.text;
  while (!rest.empty()) {
    const std::size_t end = rest.find('\n');
    job.lines.push_back(rest.substr(0, end));
    rest.remove_prefix(end + 1);
  }
}

/// Reads lines as elements of the path.
class PathReader {
 public:
  template <typename Sink>
  void read(std::string_view line, Sink&& take) {
    const auto actions = interpreter_.interpret(line);
    for (const gcode::Action& action : actions.value()) {
      if (!ActionElements::accepts(action)) continue;
      elements_.begin(action, place_, kUsual.arc_mm);
      while (!elements_.done()) {
        const ActionPart part = elements_.next();
        take(path::PathItem{.request = {.element = part.element, .feed_mm_s = part.feed_mm_s},
                            .tolerance = path_tolerance({}, kUsual),
                            .continues = part.continues});
      }
      place_ = action.end;
    }
  }

 private:
  static constexpr UsualTolerance kUsual{};

  gcode::Interpreter interpreter_;
  ActionElements elements_;
  Position place_{};
};

void interpret_lines(Job& job) {
  PathReader reader;
  for (const std::string_view line : job.lines) {
    reader.read(line, [&job](const path::PathItem& item) { job.items.push_back(item); });
  }
}

/// Passes the job through the path stage: short lines are welded, corners are rounded.
template <typename Sink>
void round_off(const Job& job, Sink&& take) {
  path::PathStage stage{limits()};
  const auto drain = [&] {
    while (const path::PathPiece* const piece = stage.next()) take(*piece);
  };
  for (const path::PathItem& item : job.items) {
    stage.put(item);
    drain();
  }
  stage.flush();
  drain();
}

void push(motion::BlockQueue& queue, const path::PathPiece& piece) {
  queue.push(motion::build_block(piece.request, limits()).value(), piece.joint);
}

/// Plans a job with a queue that is always full, as behind a fast sender.
template <typename Sink>
void drive(const Job& job, Sink&& take) {
  motion::BlockQueueOf<motion::kLookAheadBlocks> queue;
  motion::Segmenter segmenter{queue, limits()};
  segmenter.reset({});
  motion::Segment segment;
  std::size_t next = 0;
  while (next < job.pieces.size() || !segmenter.idle()) {
    while (next < job.pieces.size() && !queue.full()) push(queue, job.pieces[next++]);
    if (segmenter.next(segment)) take(segment);
  }
}

/// Passes bytes through the pipeline as a fast sender does, and passes its segments to `take`.
template <typename Sink>
void cut_text(std::string_view text, Sink&& take) {
  constexpr std::int32_t kCycleUs = 1000;
  motion::Pixels pixels;
  Pipeline pipeline{limits(), pixels};
  PathReader reader;
  LineAssembler<256> assembler;
  motion::Segment segment;
  const auto cycle = [&] {
    pipeline.attend(kCycleUs);
    if (pipeline.next(segment)) take(segment);
  };
  for (const char byte : text) {
    if (!assembler.add(byte)) continue;
    reader.read(assembler.line(), [&](const path::PathItem& item) {
      while (!pipeline.has_room()) cycle();
      benchmark::DoNotOptimize(pipeline.append(item));
    });
  }
  while (!pipeline.empty()) {
    pipeline.flush();
    cycle();
  }
}

/// Simulated pins, and the step generator that drives them.
class Motors {
 public:
  /// Plays half of the waiting time when the queue is full: a motion that runs out of segments
  /// would remain at rest.
  void take(const motion::Segment& segment) {
    while (generator_.full()) play(generator_.ticks_waiting() / 2);
    generator_.push(segment);
  }
  void finish() { play(std::numeric_limits<std::uint32_t>::max()); }
  [[nodiscard]] const hal::host::RecordingPort& port() const { return port_; }

 private:
  void play(std::uint32_t ticks) {
    let_in(generator_);
    std::uint32_t played = 0;
    while (played <= ticks) {
      const std::uint32_t wait = generator_.player().on_interrupt();
      if (wait == 0) break;
      played += wait;
    }
    let_in(generator_);
  }

  hal::host::RecordingPort port_{};
  StepGenerator<hal::host::RecordingPort, 64> generator_{port_};
};

Job make_job(std::string text) {
  Job job;
  job.text = std::move(text);
  split_lines(job);
  interpret_lines(job);
  round_off(job, [&job](const path::PathPiece& piece) { job.pieces.push_back(piece); });
  drive(job, [&job](const motion::Segment& segment) { job.segments.push_back(segment); });
  return job;
}

const Job& freeform() {
  static const Job kJob = make_job(test::freeform_job(20'000));
  return kJob;
}
const Job& arcs() {
  static const Job kJob = make_job(test::arc_job(400));
  return kJob;
}

void count_lines(benchmark::State& state, const Job& job) {
  state.counters["lines/s"] = benchmark::Counter(static_cast<double>(job.lines.size()),
                                                 benchmark::Counter::kIsIterationInvariantRate);
}

void parse(benchmark::State& state, const Job& (*of)()) {
  const Job& job = of();
  gcode::Interpreter interpreter;
  for (auto _ : state) {
    for (const std::string_view line : job.lines) {
      benchmark::DoNotOptimize(interpreter.interpret(line));
    }
  }
  count_lines(state, job);
}

void weld(benchmark::State& state, const Job& (*of)()) {
  const Job& job = of();
  for (auto _ : state) {
    round_off(job, [](const path::PathPiece& piece) { benchmark::DoNotOptimize(piece); });
  }
  count_lines(state, job);
  state.counters["pieces/line"] =
      static_cast<double>(job.pieces.size()) / static_cast<double>(job.lines.size());
}

/// Builds and plans blocks one by one with the queue full, where a block costs most.
void plan(benchmark::State& state, const Job& (*of)()) {
  const Job& job = of();
  for (auto _ : state) {
    motion::BlockQueueOf<motion::kLookAheadBlocks> queue;
    for (const path::PathPiece& piece : job.pieces) {
      if (queue.full()) queue.pop_front();
      push(queue, piece);
      queue.plan(limits(), {});
    }
    benchmark::DoNotOptimize(queue);
  }
  count_lines(state, job);
}

void plan_and_segment(benchmark::State& state, const Job& (*of)()) {
  const Job& job = of();
  for (auto _ : state) {
    drive(job, [](const motion::Segment& segment) { benchmark::DoNotOptimize(segment); });
  }
  count_lines(state, job);
  state.counters["segments/line"] =
      static_cast<double>(job.segments.size()) / static_cast<double>(job.lines.size());
}

/// Processes text to segments. All stages alternate as in the controller, without step pulses.
void cut_from_text(benchmark::State& state, const Job& (*of)()) {
  const Job& job = of();
  for (auto _ : state) {
    cut_text(job.text, [](const motion::Segment& segment) { benchmark::DoNotOptimize(segment); });
  }
  count_lines(state, job);
}

/// Processes text to step edges. All stages alternate as in the controller.
void step_from_text(benchmark::State& state, const Job& (*of)()) {
  const Job& job = of();
  for (auto _ : state) {
    Motors motors;
    cut_text(job.text, [&motors](const motion::Segment& segment) { motors.take(segment); });
    motors.finish();
    benchmark::DoNotOptimize(motors.port().position);
  }
  count_lines(state, job);
}

void step(benchmark::State& state, const Job& (*of)()) {
  const Job& job = of();
  for (auto _ : state) {
    Motors motors;
    for (const motion::Segment& segment : job.segments) motors.take(segment);
    motors.finish();
    benchmark::DoNotOptimize(motors.port().position);
  }
  count_lines(state, job);
}

/// Processes bytes to step edges through the complete firmware, including the simulator's clock.
void everything(benchmark::State& state, const Job& (*of)()) {
  const Job& job = of();
  double machine_seconds = 0.0;
  for (auto _ : state) {
    sim::Simulator simulator{job.text, {}};
    machine_seconds += simulator.run().job_time_s;
  }
  count_lines(state, job);
  state.counters["times_machine"] =
      benchmark::Counter(machine_seconds, benchmark::Counter::kIsRate);
}

BENCHMARK_CAPTURE(parse, freeform_20000, freeform)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(parse, arcs_400, arcs)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(weld, freeform_20000, freeform)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(weld, arcs_400, arcs)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(plan, freeform_20000, freeform)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(plan, arcs_400, arcs)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(plan_and_segment, freeform_20000, freeform)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(plan_and_segment, arcs_400, arcs)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(cut_from_text, freeform_20000, freeform)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(cut_from_text, arcs_400, arcs)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(step, freeform_20000, freeform)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(step, arcs_400, arcs)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(step_from_text, freeform_20000, freeform)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(step_from_text, arcs_400, arcs)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(everything, freeform_20000, freeform)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(everything, arcs_400, arcs)->Unit(benchmark::kMillisecond);

}  // namespace
