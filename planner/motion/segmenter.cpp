#include "planner/motion/segmenter.hpp"

#include <algorithm>
#include <cmath>

#include "planner/base/truncate.hpp"
#include "planner/motion/power_course.hpp"
#include "planner/motion/step_timing.hpp"

namespace cnc::motion {
namespace {
constexpr auto kTicks = static_cast<float>(kTicksPerSecond);
constexpr std::uint64_t kBlockEnd = std::uint64_t{1} << 32;
constexpr float kWholeBlock = 4294967296.0F;

bool has_steps(const Segment& segment) {
  return std::any_of(segment.trains.begin(), segment.trains.end(), [](const StepTrain& train) {
    return train.count > 0;
  });
}

/// Of two changes before the same segment the later wins, output by output.
void merge(OutputChanges& pending, const OutputChanges& later) {
  pending.raise = static_cast<std::uint8_t>((pending.raise & ~later.lower) | later.raise);
  pending.lower = static_cast<std::uint8_t>((pending.lower & ~later.raise) | later.lower);
  if (later.analog_channel == OutputChanges::kNoAnalog) return;
  pending.analog_channel = later.analog_channel;
  pending.analog_value = later.analog_value;
}

}  // namespace

void Segmenter::set_overrides(const Overrides& overrides) {
  if (overrides == overrides_) return;
  overrides_ = overrides;
  queue_.forget_plan();
  replan_ = true;
}

void Segmenter::reset(const AxisArray<StepPosition>& place) {
  queue_.clear();
  driving_ = false;
  blocks_ended_ = 0;
  phase_ = {};
  speed_ = 0.0F;
  entry_square_ = 0.0F;
  shift_ = 0.0F;
  outputs_ = {};
  here_.place = place;
}

bool Segmenter::next(Segment& segment) {
  if (idle()) return false;
  queue_.plan(limits_, overrides_);
  if (driving_) follow_plan();
  // A slice shorter than a tick is driven but not handed out; blocks of a few
  // nanometres at full speed need several of them for one segment.
  constexpr int kMostShortSlices = 64;
  // The last slice before standstill is always handed out: it says so.
  for (int slices = 0; slices < kMostShortSlices; ++slices) {
    if (!ready_phase()) {
      if (slices == 0) return false;
      break;
    }
    segment = {};
    cut(slice_units(), segment);
    if (segment.ticks > 0) break;
  }
  if (segment.ticks == 0) {
    segment.ticks = 1;
    shift_ -= 1.0F;
  }
  segment.outputs = outputs_;
  outputs_ = {};
  return true;
}

/// More blocks, an override or a hold may have changed what lies ahead.
void Segmenter::follow_plan() {
  const float exit_square = queue_.exit_square(0);
  const bool same_plan = !replan_ && exit_square == profile_.exit_square();
  if (same_plan && drive_ == phase_drive_) return;
  if (phase_.duration > 0.0F) profile_.stop_short(phase_, phase_distance_left(), speed_);
  phase_ = {};
  if (profile_.at_end()) return end_block();
  if (!same_plan) profile_.replan(queue_.front(), overrides_, exit_square);
  replan_ = false;
}

/// Makes sure there is a phase with time left; false when there is no motion.
bool Segmenter::ready_phase() {
  if (phase_.duration > 0.0F) return true;
  if (!driving_) {
    if (queue_.empty()) return false;
    begin_block();
  }
  phase_ = profile_.next_phase(drive_);
  phase_drive_ = drive_;
  if (phase_.duration <= 0.0F) {
    speed_ = 0.0F;
    return false;
  }
  course_ = PhaseCourse{phase_};
  near_reversal_ = profile_.near_reversal();
  units_done_ = 0;
  phase_from_ = fraction_;
  phase_to_ = fraction_after(phase_);
  return true;
}

/// Where on the block the phase ends. From the nearer end of the block, so that
/// rounding never falls on a short phase at its start or end.
std::uint64_t Segmenter::fraction_after(const Phase& phase) const {
  const float left = profile_.left_of_block(phase);
  if (left <= 0.0F) return kBlockEnd;
  const auto share = [this](float distance) {
    return static_cast<std::uint64_t>(truncated(distance * fraction_per_mm_ + 0.5F));
  };
  const bool nearer_start = 2.0F * left > queue_.front().length;
  const std::uint64_t place =
      nearer_start ? fraction_ + share(phase.distance) : kBlockEnd - share(left);
  return std::clamp(place, fraction_, kBlockEnd - 1);
}

float Segmenter::phase_distance_left() const {
  const std::uint64_t driven = units_done_ == 0 ? 0 : course_.share_after(units_done_);
  return phase_.distance * (static_cast<float>(kBlockEnd - driven) / kWholeBlock);
}

void Segmenter::begin_block() {
  const Block& block = queue_.front();
  profile_.begin(block, limits_, overrides_, queue_.exit_square(0), entry_square_);
  path_ = MotorPath{block, here_.place};
  fraction_ = 0;
  fraction_per_mm_ = kWholeBlock / block.length;
  here_.speed = path_.at(0).speed;
  merge(outputs_, block.outputs);
  driving_ = true;
  replan_ = false;
}

void Segmenter::end_block() {
  entry_square_ = profile_.speed_square();
  queue_.pop_front();
  ++blocks_ended_;
  driving_ = false;
}

/// Where the speed of the path or of an axis changes by more than a third of
/// itself slices are shorter, so that a parabola in the step index fits.
std::uint32_t Segmenter::slice_units() const {
  if (near_reversal_) return 1;
  const float change = 3.0F * std::abs(phase_.acceleration);
  const float longest = change * kLongestSlice > speed_ ? speed_ / change : kLongestSlice;
  const auto units = static_cast<std::uint32_t>(longest / course_.unit_s());
  return std::clamp<std::uint32_t>(units, 1, course_.units() - units_done_);
}

void Segmenter::cut(std::uint32_t units, Segment& segment) {
  const float duration = course_.unit_s() * static_cast<float>(units);
  units_done_ += units;
  const bool phase_ends = units_done_ == course_.units();
  const float speed =
      phase_ends ? std::sqrt(phase_.end_speed_square) : course_.speed_after(units_done_);
  const std::uint64_t from_fraction = fraction_;
  fraction_ =
      phase_ends
          ? phase_to_
          : phase_from_ + (((phase_to_ - phase_from_) * course_.share_after(units_done_)) >> 32);
  if (observer_ != nullptr) {
    observer_->on_slice(
        {blocks_ended_, from_fraction, fraction_, speed_, phase_.acceleration, duration});
  }
  time_trains(path_.at(fraction_), duration, segment);
  segment.power = power_course(duty_at(speed_), duty_at(speed), segment.ticks);
  speed_ = speed;
  segment.comes_to_rest = speed_ <= 0.0F;
  if (phase_ends) end_phase();
}

void Segmenter::end_phase() {
  profile_.complete(phase_);
  phase_ = {};
  if (profile_.at_end()) end_block();
}

void Segmenter::time_trains(const MotorState& to, float duration, Segment& segment) {
  const float ticks = duration * kTicks;
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    if (to.place[axis] == here_.place[axis]) continue;
    const AxisSlice slice{.from = here_.place[axis],
                          .to = to.place[axis],
                          .speed_steps_per_tick = here_.speed[axis] * speed_ / kTicks,
                          .ticks = ticks};
    segment.trains[axis] = time_steps(slice, shift_);
    if (to.place[axis].q32() < here_.place[axis].q32()) {
      segment.negative = static_cast<std::uint8_t>(segment.negative | (1U << axis));
    }
  }
  here_ = to;
  const float whole = ticks + shift_;
  segment.ticks = static_cast<std::uint32_t>(std::max(0.0F, whole));
  if (segment.ticks == 0 && has_steps(segment)) segment.ticks = 1;
  shift_ = whole - static_cast<float>(segment.ticks);
}

/// 0…1 of full output at a speed of the path on the present block.
float Segmenter::duty_at(float speed) const {
  const Block& block = queue_.front();
  const bool follows_speed = block.beam.follows_speed && block.feed > 0.0F;
  if (block.beam.duty <= 0.0F) return 0.0F;
  float share = block.beam.duty * overrides_.power;
  if (follows_speed) share *= speed / block.feed;
  const float duty = limits_.beam.table.duty_for(std::clamp(share, 0.0F, 1.0F));
  return follows_speed ? std::max(duty, limits_.beam.least_duty) : duty;
}

}  // namespace cnc::motion
