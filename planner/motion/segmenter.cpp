#include "planner/motion/segmenter.hpp"

#include <algorithm>
#include <cmath>

#include "planner/base/truncate.hpp"
#include "planner/motion/power_course.hpp"
#include "planner/motion/step_timing.hpp"

namespace cnc::motion {
namespace {

constexpr std::int32_t kNanosecondsPerTick = 1'000'000'000 / kTicksPerSecond;
constexpr float kTicksPerNanosecond = 1.0F / static_cast<float>(kNanosecondsPerTick);
constexpr std::uint32_t kLongestSliceNs = 1'000'000;
/// Where speed changes a lot.
constexpr std::uint32_t kShortSliceNs = 250'000;

bool has_steps(const Segment& segment) {
  return std::any_of(segment.trains.begin(), segment.trains.end(), [](const StepTrain& train) {
    return train.count > 0;
  });
}

}  // namespace

void Segmenter::reset(const AxisArray<StepPosition>& place) {
  queue_.clear();
  plan_.reset();
  window_ = {};
  filter_ = {};
  plan_.set_window({});
  course_ = {};
  elapsed_ns_ = 0;
  stretch_from_ = 0;
  place_ = 0;
  driving_ = false;
  blocks_ended_ = 0;
  speed_ = 0.0F;
  remainder_ns_ = 0;
  outputs_ = {};
  place_steps_ = place;
}

bool Segmenter::next(Segment& segment) {
  // A slice shorter than a tick is driven but not handed out; blocks of a few
  // nanometres at full speed need several of them for one segment.
  constexpr int kMostShortSlices = 64;
  // The last slice before standstill is always handed out: it says so.
  for (int slices = 0; slices < kMostShortSlices; ++slices) {
    if (!ready_stretch()) {
      if (slices == 0) return false;
      break;
    }
    segment = {};
    make_segment(segment);
    if (segment.ticks > 0) break;
  }
  if (segment.ticks == 0) {
    segment.ticks = 1;
    remainder_ns_ -= kNanosecondsPerTick;
  }
  segment.outputs = outputs_;
  outputs_ = {};
  return true;
}

bool Segmenter::next(std::uint32_t most_ns, PlannedSlice& slice) {
  if (!ready_stretch()) return false;
  slice = {};
  if (ready_block()) {
    const Cut cut = cut_slice(most_ns);
    move_to(cut.to);
    slice.duration_ns = static_cast<std::uint32_t>(cut.duration_ns);
    slice.start_duty = cut.start_duty;
    slice.end_duty = cut.end_duty;
  } else {
    pass_to_rest();
  }
  slice.end = place_steps_;
  slice.outputs = outputs_;
  outputs_ = {};
  return true;
}

void Segmenter::make_segment(Segment& segment) {
  if (ready_block()) {
    const Cut cut = cut_slice(kLongestSliceNs);
    time_trains(cut, segment);
    segment.power = power_course(cut.start_duty, cut.end_duty, segment.ticks);
  } else {
    // Says so in no time.
    pass_to_rest();
    segment.ticks = 1;
    remainder_ns_ -= kNanosecondsPerTick;
  }
  segment.comes_to_rest = speed_ <= 0.0F;
}

/// Makes sure there is a stretch with time left; false when there is no motion.
bool Segmenter::ready_stretch() {
  // At its end a stretch may have no time left for its last few units.
  const bool driven = place_ == stretch_from_ + course_.whole().way;
  if (!driven || elapsed_ns_ < course_.duration_ns()) return true;
  Stretch stretch;
  if (!next_stretch(stretch)) {
    speed_ = 0.0F;
    return false;
  }
  course_ = PhaseCourse{stretch};
  elapsed_ns_ = 0;
  stretch_from_ = place_;
  return true;
}

/// From the plan itself, or from what the filter makes of it.
bool Segmenter::next_stretch(Stretch& stretch) {
  const bool stands = filter_.at_rest() && plan_.speed() <= 0.0F;
  if (stands && drive_ == Drive::kOn) choose_window();
  if (!window_.filters()) return plan_.next(kLongestSliceNs, drive_, true, stretch);
  do {
    if (!fill_cell()) return false;
    stretch = filter_.take();
  } while (stretch.duration_ns == 0);
  return true;
}

/// From rest to rest it stays the same.
void Segmenter::choose_window() {
  if (plan_.at_end()) return;
  const TimeWindow window = plan_.choose_window();
  if (window == window_) return;
  window_ = window;
  plan_.set_window(window);
  filter_.begin(window);
}

/// False when neither plan nor motion move.
bool Segmenter::fill_cell() {
  const bool may_start = filter_.at_rest();
  bool moves = !may_start;
  while (filter_.room_ns() > 0) {
    Stretch stretch;
    if (plan_.next(filter_.room_ns(), drive_, may_start && !moves, stretch)) {
      filter_.add(stretch);
      moves = true;
    } else if (moves) {
      filter_.rest();
    } else {
      return false;
    }
  }
  return true;
}

/// Of the time in which the motion comes to rest nothing may be left to drive.
bool Segmenter::ready_block() {
  if (driving_) return true;
  if (queue_.empty()) return false;
  begin_block();
  return true;
}

void Segmenter::begin_block() {
  const Block& block = queue_.front();
  path_ = MotorPath{block, place_steps_};
  length_ = length_in_units(block);
  fraction_ = BlockFraction{length_};
  reversals_ = Reversals{block, length_};
  power_.begin(block, length_);
  const MotorPath::Point start = path_.at(0);
  for (const std::size_t axis : path_.moving()) rates_[axis] = path_.speed(axis, start);
  merge(outputs_, block.outputs);
  driving_ = true;
}

void Segmenter::end_block() {
  plan_.block_left();
  queue_.pop_front();
  ++blocks_ended_;
  driving_ = false;
  stretch_from_ -= length_;
  place_ = 0;
}

/// Where the speed of the path or of an axis changes by more than a third of
/// itself slices are shorter, so that a parabola in the step index fits. Slices
/// of a stretch are equally long.
std::uint64_t Segmenter::longest_slice_ns() const {
  const float change = 3.0F * std::abs(course_.whole().acceleration) * kLongestSlice;
  const bool changes = change > speed_ || reversals_.near(place_);
  const std::uint32_t longest = changes ? kShortSliceNs : kLongestSliceNs;
  const auto left = static_cast<std::uint32_t>(course_.duration_ns() - elapsed_ns_);
  const std::uint32_t slices = std::max<std::uint32_t>(1, (left + longest - 1) / longest);
  return (left + slices - 1) / slices;
}

/// The next slice ends with the stretch, where the block does, where an axis
/// reverses, or where the power changes.
Segmenter::Cut Segmenter::cut_slice(std::uint64_t most_ns) {
  const std::uint64_t longest = std::min(longest_slice_ns(), most_ns);
  std::uint64_t end_ns = std::min(elapsed_ns_ + longest, course_.duration_ns());
  PathUnits end = stretch_from_ + course_.way_after(end_ns);
  const PathUnits stop = std::min(reversals_.next(), power_.next_change());
  if (end > stop) {
    end_ns = elapsed_ns_ + course_.time_of(stop - place_, elapsed_ns_);
    end = stop;
  }
  return cut(end_ns, end);
}

void Segmenter::move_to(const MotorPath::Point& point) {
  for (const std::size_t axis : path_.moving()) place_steps_[axis] = path_.place(axis, point);
}

void Segmenter::pass_to_rest() {
  elapsed_ns_ = course_.duration_ns();
  stretch_from_ = place_ - course_.whole().way;
  speed_ = 0.0F;
}

Segmenter::Cut Segmenter::cut(std::uint64_t end_ns, PathUnits end) {
  const std::uint64_t duration_ns = end_ns - elapsed_ns_;
  const float speed = course_.speed_after(end_ns);
  const std::uint64_t to_fraction = fraction_.of(end);
  if (observer_ != nullptr) {
    observer_->on_slice({blocks_ended_,
                         fraction_.of(place_),
                         to_fraction,
                         speed_,
                         course_.whole().acceleration,
                         nearest_float(duration_ns) * kSecondsPerNanosecond});
  }
  const Cut cut{.to = path_.at(to_fraction),
                .duration_ns = duration_ns,
                .start_speed = speed_,
                .start_duty = duty_at(speed_),
                .end_duty = duty_at(speed)};
  speed_ = speed;
  place_ = end;
  reversals_.pass(place_);
  power_.pass(place_);
  elapsed_ns_ = end_ns;
  if (place_ == length_) end_block();
  return cut;
}

void Segmenter::time_trains(const Cut& cut, Segment& segment) {
  // What takes no time is a rounding of the stretch: a step of it is due at once.
  const float ticks =
      nearest_float(std::max<std::uint64_t>(1, cut.duration_ns)) * kTicksPerNanosecond;
  const float shift = static_cast<float>(remainder_ns_) * kTicksPerNanosecond;
  const float speed_per_tick = cut.start_speed / static_cast<float>(kTicksPerSecond);
  for (const std::size_t axis : path_.moving()) {
    const AxisSlice slice{.from = place_steps_[axis],
                          .to = path_.place(axis, cut.to),
                          .speed_steps_per_tick = rates_[axis] * speed_per_tick,
                          .ticks = ticks};
    segment.trains[axis] = time_steps(slice, shift);
    if (slice.to.q32() < slice.from.q32()) {
      segment.negative = static_cast<std::uint8_t>(segment.negative | (1U << axis));
    }
    place_steps_[axis] = slice.to;
    rates_[axis] = path_.speed(axis, cut.to);
  }
  pass_time(cut.duration_ns, segment);
}

/// Segments last whole ticks; what is left of one goes to the next.
void Segmenter::pass_time(std::uint64_t duration_ns, Segment& segment) {
  const std::int32_t whole = static_cast<std::int32_t>(duration_ns) + remainder_ns_;
  segment.ticks =
      static_cast<std::uint32_t>(std::max<std::int32_t>(0, whole / kNanosecondsPerTick));
  if (segment.ticks == 0 && has_steps(segment)) segment.ticks = 1;
  remainder_ns_ = whole - static_cast<std::int32_t>(segment.ticks) * kNanosecondsPerTick;
}

/// 0…1 of full output at a speed of the path at the present place.
float Segmenter::duty_at(float speed) const {
  const Block& block = queue_.front();
  const bool follows_speed = block.beam.follows_speed && block.feed > 0.0F;
  if (power_.duty() <= 0.0F) return 0.0F;
  float share = power_.duty() * plan_.overrides().power;
  if (follows_speed) share *= speed / block.feed;
  const float duty = limits_.beam.table.duty_for(std::clamp(share, 0.0F, 1.0F));
  return follows_speed ? std::max(duty, limits_.beam.least_duty) : duty;
}

}  // namespace cnc::motion
