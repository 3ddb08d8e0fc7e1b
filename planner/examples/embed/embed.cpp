/// Shows the planner in another program: converts a line of G-code to step segments.
///
///     embed 'G1 X10 Y5 F3000'
///
/// Prints a line for each segment: its length in seconds and the steps of X, Y and Z.

#include <iostream>
#include <memory>

#include "planner/gcode/interpreter.hpp"
#include "planner/pipeline/action_elements.hpp"
#include "planner/pipeline/path_tolerance.hpp"
#include "planner/pipeline/pipeline.hpp"

namespace {

void print(const cnc::motion::Segment& segment) {
  std::cout << static_cast<double>(segment.ticks) / cnc::motion::kTicksPerSecond;
  for (std::size_t axis = 0; axis < cnc::kLinearAxisCount; ++axis) {
    const bool backwards = (segment.negative >> axis & 1U) != 0;
    std::cout << ' ' << (backwards ? "-" : "") << segment.trains[axis].count;
  }
  std::cout << '\n';
}

/// Runs one cycle of a main loop: a millisecond passes, and all segments that are ready are
/// printed.
void run_cycle(cnc::Pipeline& pipeline) {
  pipeline.attend(1000);
  for (cnc::motion::Segment segment; pipeline.next(segment);) print(segment);
}

/// Drives an action of G-code that moves, element by element. Returns false if its end is out of
/// the range of the motors.
bool drive(const cnc::gcode::Action& action,
           const cnc::gcode::PathControl& control,
           cnc::Pipeline& pipeline) {
  cnc::ActionElements elements;
  elements.begin(action, pipeline.target(), cnc::spline_tolerance(control, {}));
  while (!elements.done()) {
    while (!pipeline.has_room()) run_cycle(pipeline);
    const cnc::ActionPart part = elements.next();
    const auto appended =
        pipeline.append({.request = {.element = part.element, .feed_mm_s = part.feed_mm_s},
                         .tolerance = cnc::path_tolerance(control, {}),
                         .continues = part.continues});
    if (!appended.ok()) return false;
  }
  return true;
}

int refuse(const char* line) {
  std::cerr << "embed: '" << line << "' is refused\n";
  return 1;
}

}  // namespace

int main(int count, char** words) {
  cnc::motion::Limits limits;
  limits.scale.fill(cnc::AxisScale{80.0F});  // Steps per mm.
  limits.rate_mm_s.fill(200.0F);
  limits.acceleration_mm_s2.fill(1000.0F);
  limits.jerk_mm_s3.fill(50'000.0F);
  const auto pixels = std::make_unique<cnc::motion::Pixels>();
  const auto pipeline = std::make_unique<cnc::Pipeline>(limits, *pixels);
  cnc::gcode::Interpreter interpreter;

  for (int i = 1; i < count; ++i) {
    const auto actions = interpreter.interpret(words[i]);
    if (!actions.ok()) return refuse(words[i]);
    for (const cnc::gcode::Action& action : actions.value()) {
      if (!cnc::ActionElements::accepts(action)) continue;  // Spindle, dwell and the like.
      if (!drive(action, interpreter.state().path, *pipeline)) return refuse(words[i]);
    }
  }
  while (!pipeline->empty()) {
    pipeline->flush();
    run_cycle(*pipeline);
  }
}
