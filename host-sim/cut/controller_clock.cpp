#include "host-sim/cut/controller_clock.hpp"

#include <algorithm>
#include <utility>

#include "planner/base/contract.hpp"

namespace sim::cut {
namespace {

using cnc::motion::Drive;
using cnc::motion::Limits;

/// Time that is longer than any stretch of a plan, ns.
constexpr std::uint32_t kAnyNs = 1'000'000'000;
/// Time that the controller takes for one line of the program, s: one cycle of its main loop.
constexpr double kLineS = 1.0e-3;
/// Time from the moment when the first block of a chain is known until the window of the chain is
/// chosen, s. The controller reads one more line in this time.
constexpr double kStartS = 1.5 * kLineS;
/// Time for which the controller rests at each stop before it continues, s. It is a number of
/// cycles, as measured on the simulated controller.
constexpr double kStandstillS = 4.0e-3;
/// Time between the division of the plan into segments and the motion of these segments, s. The
/// controller divides the plan ahead of the motion.
constexpr double kAheadS = 0.020;

Limits limits_of(const OrderWish& machine) {
  constexpr float kNoLimit = 1.0e9F;
  Limits limits;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    limits.scale[axis] = cnc::AxisScale{static_cast<float>(machine.steps_per_mm[axis])};
    limits.rate_mm_s[axis] = static_cast<float>(machine.limits.rate_mm_s[axis]);
    limits.acceleration_mm_s2[axis] = static_cast<float>(machine.limits.acceleration_mm_s2[axis]);
    limits.jerk_mm_s3[axis] = static_cast<float>(machine.limits.jerk_mm_s3[axis]);
  }
  limits.junction_deviation_mm = static_cast<float>(machine.junction_deviation_mm);
  // The machine's rates already include the limits of the motors.
  limits.steps_per_s_one_motor = kNoLimit;
  return limits;
}

cnc::path::Tolerance tolerance_of(const OrderWish& machine) {
  return cnc::path::tolerance_within(static_cast<float>(machine.junction_deviation_mm),
                                     static_cast<float>(machine.arc_tolerance_mm));
}

}  // namespace

ControllerClock::ControllerClock(const OrderWish& machine)
    : limits_{limits_of(machine)},
      tolerance_{tolerance_of(machine)},
      path_{limits_},
      plan_{queue_, limits_},
      written_{cnc::gcode::PrintGrid{machine.decimals}, machine.from} {}

void ControllerClock::move(const Stroke& path, double feed_mm_s, bool is_lit) {
  times_.push_back(0.0);
  cnc::path::PathItem item{.tolerance = tolerance_};
  item.request.feed_mm_s = static_cast<float>(feed_mm_s);
  item.request.beam.duty = is_lit ? 1.0F : 0.0F;
  item.request.line = static_cast<std::uint32_t>(times_.size() - 1);
  for (const cnc::PathElement& element : written_.next(path)) {
    item.request.element = element;
    put(item);
    item.continues = true;
  }
}

/// Appends an element to the path. If the path is full, drives motions until there is free space.
void ControllerClock::put(const cnc::path::PathItem& item) {
  while (!path_.has_room()) {
    make_blocks();
    if (path_.has_room()) break;
    CNC_ASSERT(drive());
  }
  path_.put(item);
  read_s_ += kLineS;
  make_blocks();
}

/// Makes blocks of the finished pieces of the path. A piece that the motors cannot reach is left
/// out, because the machine refuses a program that contains it. A chain is driven as soon as its
/// end is known, because blocks after a stop do not affect the motion before the stop. So each plan
/// consists of few blocks.
void ControllerClock::make_blocks() {
  while (!queue_.full()) {
    const cnc::path::PathPiece* const piece = path_.next();
    if (piece == nullptr) return;
    const auto block = cnc::motion::build_block(piece->request, limits_);
    if (!block.ok()) continue;
    queue_.push(block.value(), piece->joint);
    double& left_s = left_s_[pushed_++ % left_s_.size()];
    // No line is read while the queue is full, so the next line is read when the plan leaves a
    // block.
    read_s_ = std::max(read_s_, left_s);
    if (!queue_.at(queue_.size() - 1).from_rest) continue;
    while (queue_.size() > 1) CNC_ASSERT(drive());
    ready_s_ = read_s_;
  }
}

/// Follows the plan for one stretch, and adds the time of the stretch to its motion. Returns false
/// if there is nothing to drive.
bool ControllerClock::drive() {
  if (plan_.at_end()) return false;
  const cnc::motion::SourceLine line = queue_.at(plan_.blocks_left()).line;
  // Line numbers have 24 bits, so they repeat. The driven motion is the newest motion with this
  // number.
  constexpr std::size_t kLineNumbers = std::size_t{1} << 24U;
  const std::size_t newest = times_.size() - 1;
  const std::size_t motion = newest - (newest - line.number) % kLineNumbers;
  if (plan_.speed() <= 0.0F) begin_chain(motion);
  const cnc::motion::Stretch stretch = plan_.next(kAnyNs, Drive::kOn, true);
  if (!stretch.lasts()) return false;
  last_ = motion;
  pass(motion, 1.0e-9 * static_cast<double>(stretch.duration_ns));
  while (plan_.blocks_left() > 0) {
    plan_.block_left();
    queue_.pop_front();
    left_s_[left_++ % left_s_.size()] = now_s_;
  }
  return true;
}

void ControllerClock::pass(std::size_t motion, double seconds) {
  times_[motion] += seconds;
  now_s_ += seconds;
}

/// Begins a chain and chooses its window for the blocks up to the next stop, as the controller's
/// segmenter does. If the next stop is not yet known, chooses the longest window.
void ControllerClock::begin_chain(std::size_t motion) {
  end_chain();
  in_chain_ = true;
  const bool is_known = read_s_ <= std::max(ready_s_ + kStartS, now_s_ - kAheadS);
  if (ready_s_ > now_s_) pass(motion, ready_s_ - now_s_);
  const cnc::motion::TimeWindow window = is_known ? plan_.choose_window() : longest_window();
  if (window == window_) return;
  window_ = window;
  plan_.set_window(window);
}

cnc::motion::TimeWindow ControllerClock::longest_window() {
  queue_.stand();
  std::uint8_t axes = 0;
  for (std::size_t i = plan_.blocks_left(); i < queue_.size(); ++i) {
    axes = static_cast<std::uint8_t>(axes | cnc::motion::moving_axes(queue_.at(i)));
  }
  return cnc::motion::window_for(limits_, axes);
}

/// Ends a chain. The actual motion is the mean of the plan over the window, so it ends later than
/// the plan by the length of the window.
void ControllerClock::end_chain() {
  if (in_chain_) pass(last_, static_cast<double>(window_.seconds()));
  in_chain_ = false;
}

void ControllerClock::rest() {
  read_s_ += kLineS;
  do {
    path_.flush();
    make_blocks();
    queue_.leave_none_out();
    if (path_.empty()) queue_.expect_no_more();
  } while (drive() || !path_.empty());
  end_chain();
  if (!times_.empty()) pass(last_, kStandstillS);
  read_s_ = ready_s_ = now_s_;
}

std::vector<double> ControllerClock::finish() {
  rest();
  last_ = 0;
  return std::exchange(times_, {});
}

}  // namespace sim::cut
