#include "firmware/machine/homing.hpp"

#include <algorithm>
#include <cmath>

#include "firmware/machine/travel.hpp"
#include "planner/base/units.hpp"

namespace cnc {
namespace {

constexpr std::uint32_t kPasses = 6;
constexpr float kSeekTravels = 1.5F;
/// Maximum length of a slow approach, as a multiple of the pull-off distance. The approach must be
/// longer than the pull-off that precedes it.
constexpr float kLocatePullOffs = 5.0F;
/// Maximum search distance, mm. The steps of a longer search would overflow the counters.
constexpr float kLongestSearchMm = 400'000.0F;
constexpr float kFullTurnDegrees = 360.0F;
/// Maximum distance between the switch positions of the two motors of an axis, as a share of the
/// travel. The value is Grbl's default.
constexpr float kSkewShare = 0.05F;
constexpr float kMinSkewMm = 2.5F;
constexpr float kMaxSkewMm = 25.0F;

}  // namespace

void Homing::start(std::uint8_t axes, const motion::BeamCommand& beam) {
  beam_ = beam;
  wanted_ = axes;
  for (std::size_t pass = 0; axes == 0 && pass < kPasses; ++pass) {
    const float mask = settings_.get(setting::kHomingPassAxes, pass);
    wanted_ = static_cast<std::uint8_t>(wanted_ | static_cast<std::uint8_t>(mask));
  }
  done_ = 0;
  pass_ = 0;
  axes_ = 0;
  drive_.unwatch_switches();
  settle(Step::kPulledOff);
}

/// Selects the requested axes of the next pass; skips passes without requested axes. Requested axes
/// that are in no pass are homed last. Returns false if no axes are left.
bool Homing::next_pass() {
  axes_ = 0;
  while (axes_ == 0 && pass_ < kPasses) {
    const float mask = settings_.get(setting::kHomingPassAxes, pass_++);
    axes_ = static_cast<std::uint8_t>(static_cast<std::uint8_t>(mask) & wanted_);
  }
  if (axes_ == 0) axes_ = wanted_;
  wanted_ = static_cast<std::uint8_t>(wanted_ & ~axes_);
  locates_ = 0;
  return axes_ != 0;
}

Homing::Outcome Homing::poll(const hal::InputState& read, std::int32_t elapsed_us) {
  dwell_.pass(elapsed_us);
  switch (step_) {
    case Step::kApproach:
      return attend_approach();
    case Step::kBrake:
      return motion_.halted() || motion_.drained() ? after_stop() : Outcome::kGoingOn;
    case Step::kSettle:
      if (!dwell_.over()) return Outcome::kGoingOn;
      return left_ != 0 ? go_on_approaching() : pull_off();
    case Step::kPullOff:
      if (motion_.drained()) settle(Step::kPulledOff);
      return Outcome::kGoingOn;
    case Step::kPulledOff:
      return dwell_.over() ? after_pull_off(read) : Outcome::kGoingOn;
  }
  return Outcome::kGoingOn;
}

Homing::Outcome Homing::begin_approach() {
  left_ = axes_;
  from_ = motion_.target();
  // In the fast search, the first of the two switches ends the approach of an axis with two motors.
  drive_.watch_switches(axes_, locates_ > 0 ? squared() : std::uint8_t{0});
  return go_on_approaching();
}

/// Moves all axes that have not found their switch. They move by the same distance, so that each
/// axis moves at the full rate. The motion ends where one of the axes has reached its maximum
/// search distance.
Homing::Outcome Homing::go_on_approaching() {
  const Position here = motion_.target();
  Coordinate distance{Coordinate::kFarthestNanometres};
  int linear = 0;
  int all = 0;
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    if (!moves(axis, left_)) continue;
    const Coordinate searched =
        homes_low(axis) ? from_[axis] - here[axis] : here[axis] - from_[axis];
    distance = std::min(distance, search_distance(axis) - searched);
    linear += axis < kLinearAxisCount ? 1 : 0;
    ++all;
  }
  if (distance <= Coordinate{}) return not_found();
  Position end = here;
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    if (moves(axis, left_)) end[axis] += homes_low(axis) ? -distance : distance;
  }
  const float rate =
      settings_.get(locates_ > 0 ? setting::kHomingLocateRate : setting::kHomingSeekRate);
  step_ = Step::kApproach;
  return move_to(end, rate * std::sqrt(static_cast<float>(linear > 0 ? linear : all)));
}

Homing::Outcome Homing::attend_approach() {
  if ((drive_.switches_found() & left_) != 0) {
    motion_.halt();
    step_ = Step::kBrake;
    return Outcome::kGoingOn;
  }
  return motion_.drained() ? not_found() : Outcome::kGoingOn;
}

Homing::Outcome Homing::after_stop() {
  motion_.drop_rest();
  motion_.go_on();
  const auto found = static_cast<std::uint8_t>(drive_.switches_found() & left_);
  left_ = static_cast<std::uint8_t>(left_ & ~found);
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    if (!moves(axis, found & squared()) || locates_ == 0) continue;
    const AxisScale scale{settings_.get(setting::kStepsPerMm, axis)};
    const Coordinate skew = scale.place_of(std::abs(drive_.switch_skew(axis)));
    if (skew > greatest_skew(axis)) return Outcome::kSecondSwitch;
  }
  settle(Step::kSettle);
  return Outcome::kGoingOn;
}

Homing::Outcome Homing::pull_off() {
  Position end = motion_.target();
  AxisArray<std::int32_t> steps = motion_.tool_steps();
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    if (!moves(axis, axes_)) continue;
    steps[axis] = motion_.tool_at_contact(axis, drive_.switch_position(axis));
    closed_at_[axis] = steps[axis];
  }
  const Position closed = motion_.place_of(steps);
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    if (!moves(axis, axes_)) continue;
    end[axis] = closed[axis] + (homes_low(axis) ? pull_off_distance() : -pull_off_distance());
  }
  step_ = Step::kPullOff;
  return move_to(end, settings_.get(setting::kHomingSeekRate));
}

Homing::Outcome Homing::after_pull_off(const hal::InputState& read) {
  if (axes_ != 0) {
    if (((read.limits | read.second_limits) & axes_) != 0) return Outcome::kStillClosed;
    if (static_cast<float>(locates_) < settings_.get(setting::kHomingPasses)) {
      ++locates_;
      return begin_approach();
    }
    const Outcome finished = finish_pass();
    if (finished != Outcome::kGoingOn) return finished;
  }
  return next_pass() ? begin_approach() : Outcome::kDone;
}

/// Sets the step counts and the machine coordinates of the axes of this pass by the positions of
/// their switches. The motors do not move.
Homing::Outcome Homing::finish_pass() {
  const AxisArray<std::int32_t> steps = motion_.tool_steps();
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    if (!moves(axis, axes_)) continue;
    const AxisScale scale{settings_.get(setting::kStepsPerMm, axis)};
    const auto at_switch = scale.steps_at(switch_place(axis));
    if (!at_switch) return Outcome::kNoSwitch;
    const std::int32_t beyond = steps[axis] - closed_at_[axis];
    motion_.set_tool(axis, at_switch->nearest_step() + beyond);
  }
  drive_.unwatch_switches();
  motion_.drop_rest();
  done_ = static_cast<std::uint8_t>(done_ | axes_);
  return Outcome::kGoingOn;
}

void Homing::settle(Step next) {
  step_ = next;
  dwell_.start(1.0e-3F * settings_.get(setting::kHomingDebounce));
}

bool Homing::homes_low(std::size_t axis) const {
  const auto mask = static_cast<unsigned>(settings_.get(setting::kHomingDirectionInvert));
  return (mask >> axis & 1U) != 0;
}

std::uint8_t Homing::squared() const {
  return static_cast<std::uint8_t>(static_cast<unsigned>(settings_.get(setting::kSquaredAxes)) &
                                   axes_);
}

Coordinate Homing::search_distance(std::size_t axis) const {
  if (locates_ > 0) {
    const Coordinate slow = from_mm(kLocatePullOffs * settings_.get(setting::kHomingPullOff));
    return moves(axis, squared()) ? slow + greatest_skew(axis) : slow;
  }
  const float travel = settings_.get(setting::kTravel, axis);
  const float way = kSeekTravels * (travel > 0.0F ? travel : kFullTurnDegrees);
  return from_mm(std::min(way, kLongestSearchMm));
}

Coordinate Homing::greatest_skew(std::size_t axis) const {
  const float travel = settings_.get(setting::kTravel, axis);
  return from_mm(std::clamp(kSkewShare * travel, kMinSkewMm, kMaxSkewMm));
}

Coordinate Homing::pull_off_distance() const {
  return from_mm(settings_.get(setting::kHomingPullOff));
}

/// Returns the machine coordinate of an axis's switch. Without $22 bit 3, the switch is at an end
/// of the travel. With this bit, homing sets the origin: the axis is at zero after the pull-off.
Coordinate Homing::switch_place(std::size_t axis) const {
  if (has_homing_option(settings_, homing_option::kSetOrigin)) {
    return homes_low(axis) ? -pull_off_distance() : pull_off_distance();
  }
  const AxisTravel travel = travel_of(settings_, axis);
  return homes_low(axis) ? travel.least : travel.most;
}

Homing::Outcome Homing::not_found() const {
  return drive_.switches_half_found() != 0 ? Outcome::kSecondSwitch : Outcome::kNoSwitch;
}

/// Moves to `end`.
/// @param feed_mm_min speed along the path
Homing::Outcome Homing::move_to(const Position& end, float feed_mm_min) {
  const auto appended =
      motion_.append({.request = {.element = {.start = motion_.target(), .end = end},
                                  .feed_mm_s = feed_mm_min / kSecondsPerMinute,
                                  .beam = beam_,
                                  .fixed_feed = true}});
  motion_.flush();
  return appended.ok() ? Outcome::kGoingOn : Outcome::kNoSwitch;
}

}  // namespace cnc
