#include "planner/motion/segment/segmenter.hpp"

#include <algorithm>
#include <cmath>

#include "planner/base/scalar_math.hpp"
#include "planner/base/truncate.hpp"
#include "planner/motion/block/block_rest.hpp"

namespace cnc::motion {
namespace {

constexpr std::uint32_t kLongestSliceNs = 1'000'000;
/// Longest slice where the speed of the path or of an axis changes by more than a third.
constexpr std::uint32_t kShortSliceNs = 250'000;
/// Slices shorter than kShortestNs are joined to one segment of at most kLongestJoinedNs. Such a
/// segment is short enough that a parabola fits its step times.
constexpr std::uint32_t kShortestNs = SegmentRate::kShortest * kNsPerTick;
constexpr std::uint32_t kLongestJoinedNs = 2 * kShortestNs;

/// Greatest half sweep of a slice in radians: a slice turns by at most a 48th of a turn.
constexpr float kWidestSlice = kTwoPi / 96.0F;
constexpr float kFar = 1.0e12F;  // mm

float fraction_of(std::uint64_t q32) {
  return static_cast<float>(static_cast<std::uint32_t>(q32 >> 8U)) * (1.0F / 16'777'216.0F);
}

}  // namespace

void Segmenter::reset(const AxisArray<StepPosition>& place) {
  queue_.clear(place);
  ended_ = travelled();
  blocks_ended_ = 0;
  stand(place);
}

void Segmenter::go_back(PathUnits place, PathUnits distance) {
  ended_ = travelled() - static_cast<std::uint64_t>(distance);
  const Block& whole = queue_.front();
  place_steps_ = queue_.start_of_front();
  path_.begin(whole, place_steps_);
  fraction_ = BlockFraction{length_in_units(whole)};
  move_to(path_.at(fraction_.of(place)));
  queue_.begin_at(place_steps_, rest_of(whole, place_steps_, place, limits_));
  stand(place_steps_);
}

/// Forgets the motion so far. The motors are at rest at `place` now.
void Segmenter::stand(const AxisArray<StepPosition>& place) {
  plan_.reset();
  stretch_ = {};
  place_ = 0;
  driving_ = false;
  speed_ = 0.0F;
  joined_.reset();
  outputs_ = {};
  place_steps_ = place;
  kerf_.reset();
}

AxisArray<StepPosition> Segmenter::motors() const {
  AxisArray<StepPosition> motors = place_steps_;
  if (kerf_.follows()) kerf_.add_to(motors);
  const bool leans = kinematics::kHasFiveAxes && centre_ != nullptr;
  return leans ? centre_->axes_for(motors, limits_.scale) : motors;
}

bool Segmenter::next(Segment& segment) {
  // A segment shorter than a tick is not handed out. Its time goes into the next segment. With
  // blocks of a few nanometres at full speed, several slices are necessary for one segment.
  constexpr int kMaxShortSlices = 64;
  // The last segment before a rest is handed out even if it is shorter than a tick, because it
  // carries comes_to_rest.
  for (int slices = 0; slices < kMaxShortSlices; ++slices) {
    if (!ready_stretch()) {
      if (slices == 0) return false;
      break;
    }
    make_segment(segment);
    if (segment.ticks > 0) break;
  }
  if (segment.ticks == 0) joined_.lend_tick(segment);
  rate_.begin();
  rate_.pass(segment.ticks);
  segment.outputs = outputs_;
  outputs_ = {};
  return true;
}

bool Segmenter::next(std::uint32_t max_ns, PlannedSlice& slice) {
  if (!ready_stretch()) return false;
  slice = {};
  if (ready_block()) {
    slice.line = power_.line();
    const Cut cut = cut_slice(max_ns);
    move_to(cut.to);
    slice.duration_ns = cut.duration_ns;
    slice.start_duty = cut.duty.start;
    slice.end_duty = cut.duty.end;
  } else {
    slice.line = power_.line();
    pass_to_rest();
  }
  slice.end = motors();
  slice.outputs = outputs_;
  outputs_ = {};
  return true;
}

void Segmenter::make_segment(Segment& segment) {
  segment.negative = 0;
  for (StepTrain& train : segment.trains) train.count = 0;
  if (ready_block()) {
    begin_joined();
    join_next(kLongestSliceNs);
    while (joins_next()) join_next(kLongestJoinedNs - joined_.duration_ns());
    const std::int32_t rest_ns = joined_.rest_ns();
    joined_.time(place_steps_, segment);
    output_.write(rest_ns, segment);
  } else {
    // No block is left. Reports the rest of the motion in a segment of one tick. The next segment
    // is shorter by this tick.
    pass_to_rest();
    segment.power = {};
    segment.level_count = 0;
    joined_.lend_tick(segment);
  }
  segment.line = line_;
  segment.comes_to_rest = speed_ <= 0.0F;
}

void Segmenter::begin_joined() {
  joined_.begin(place_steps_);
  output_.begin();
  line_ = power_.line();
  monotonic_to_ = reversals_.next();
  const float speed_per_tick = speed_ / static_cast<float>(kTicksPerSecond);
  for (const MotorPath::Motor& motor : path_.moving()) {
    joined_.set_speed(motor.axis(), rates_[motor.axis()] * speed_per_tick);
  }
}

/// Cuts the next slice, over one pixel or over several short pixels, and joins it to the segment.
void Segmenter::join_next(std::uint32_t max_ns) {
  if (pixels_are_short()) {
    const End end = end_of_slice(reversals_.next(), kShortSliceNs);
    add_pixels(end);
    return join(cut(end));
  }
  const Cut cut = cut_slice(max_ns);
  output_.add(cut.duty.start, cut.duty.end, cut.duration_ns);
  join(cut);
}

/// Returns whether the power of a row changes before a segment of the shortest duration would end.
bool Segmenter::pixels_are_short() {
  if (power_.next_change() >= length_) return false;
  return power_.changes_before(stretch_.place_after(stretch_.elapsed_ns() + kShortestNs));
}

/// Adds the power of each pixel up to the end of a slice. Within the slice, the speed is assumed to
/// change linearly with distance. At 10,000 mm/s², this error moves a change of power by at most
/// 0.1 µm.
void Segmenter::add_pixels(const End& end) {
  const float way_mm = to_mm(end.place - place_);
  const float ns_per_mm = static_cast<float>(end.ns - stretch_.elapsed_ns()) / way_mm;
  const float speed_per_mm = (stretch_.speed_after(end.ns) - speed_) / way_mm;
  float from_mm = 0.0F;
  const auto add_until = [&](PathUnits place) {
    const float until_mm = to_mm(place - place_);
    const float speed = speed_ + 0.5F * (from_mm + until_mm) * speed_per_mm;
    const float duty = duty_at(speed);
    output_.add(duty, duty, static_cast<std::uint32_t>((until_mm - from_mm) * ns_per_mm));
    from_mm = until_mm;
  };
  while (power_.changes_before(end.place)) {
    add_until(power_.next_change());
    power_.pass(power_.next_change());
  }
  add_until(end.place);
}

void Segmenter::join(const Cut& cut) {
  joined_.add(cut.duration_ns);
  for (const MotorPath::Motor& motor : path_.moving()) {
    place_steps_[motor.axis()] = motor.place(cut.to);
    rates_[motor.axis()] = motor.speed(cut.to);
  }
}

/// Returns whether the next slice is to be joined to the segment, and makes sure that this slice
/// exists. The segment must be short, no outputs may change, and each motor must continue in its
/// direction. The power must not jump, unless SegmentRate allows no short segment.
bool Segmenter::joins_next() {
  if (joined_.duration_ns() >= kShortestNs || speed_ <= 0.0F || !ready_stretch()) return false;
  if (!driving_ && (queue_.empty() || queue_.front().outputs.any())) return false;
  if (!ready_block()) return false;
  const bool is_even = duty_at(speed_) == output_.end_duty();
  return (is_even || !rate_.allows_short()) && goes_on_as_joined();
}

/// Returns whether each motor continues in the direction of the joined slices. No axis reverses
/// before the next reversal, so the distance up to there gives the direction of each motor.
bool Segmenter::goes_on_as_joined() {
  const PathUnits next = reversals_.next();
  if (place_ > 0 && next == monotonic_to_) return true;
  monotonic_to_ = next;
  const MotorPath::Point ahead = path_.at(fraction_.of(next));
  for (const MotorPath::Motor& motor : path_.moving()) {
    const StepPosition here = place_steps_[motor.axis()];
    const std::int64_t gone = joined_.gone(motor.axis(), here);
    const std::int64_t way = motor.place(ahead).q32() - here.q32();
    if ((gone < 0 && way > 0) || (gone > 0 && way < 0)) return false;
  }
  return true;
}

/// Makes sure that there is a stretch with time left. Returns false if there is no motion.
bool Segmenter::ready_stretch() {
  if (!stretch_.is_over(place_)) return true;
  const Stretch stretch = plan_.next(kLongestSliceNs);
  if (!stretch.lasts()) {
    speed_ = 0.0F;
    return false;
  }
  stretch_.begin(stretch, place_);
  return true;
}

/// Begins the front block unless it has begun. Returns false if the queue is empty, which is
/// possible while the motion comes to rest.
bool Segmenter::ready_block() {
  if (driving_) return true;
  if (queue_.empty()) return false;
  begin_block();
  return true;
}

void Segmenter::begin_block() {
  const Block& block = queue_.front();
  path_.begin(block, place_steps_);
  length_ = length_in_units(block);
  fraction_ = BlockFraction{length_};
  reversals_ = Reversals{block, length_};
  // Under a time window, stretches are so short that no limit of the angle of a slice is necessary.
  const bool widely = block.turns() && !plan_.window().filters();
  widest_mm_ = widely ? kWidestSlice * block.length / std::abs(block.turn.half_sweep) : kFar;
  power_.begin(block, length_);
  const MotorPath::Point start = path_.at(0);
  for (const MotorPath::Motor& motor : path_.moving()) rates_[motor.axis()] = motor.speed(start);
  merge(outputs_, block.outputs);
  if (kerf_.follows()) kerf_.begin(block);
  driving_ = true;
}

void Segmenter::end_block() {
  plan_.block_left();
  queue_.pop_front();
  ++blocks_ended_;
  ended_ += static_cast<std::uint64_t>(length_);
  driving_ = false;
  stretch_.leave_block(length_);
  place_ = 0;
}

/// Returns the greatest duration of the next slice, in ns. Slices are shorter where the speed of
/// the path or of an axis changes by more than a third. On an arc, a slice turns by at most a 48th
/// of a turn. So a parabola in the step index fits the step times. The rest of the stretch is
/// divided into slices of equal duration.
std::uint32_t Segmenter::longest_slice_ns() const {
  const std::uint32_t left = stretch_.left_ns();
  std::uint32_t longest = kShortSliceNs;
  if (left > kShortSliceNs) {
    const float change = 3.0F * std::abs(stretch_.acceleration()) * kLongestSlice;
    const bool changes = change > speed_ || reversals_.near(place_);
    longest = changes ? kShortSliceNs : kLongestSliceNs;
  }
  if (speed_ * kLongestSlice > widest_mm_) {
    const float turning_ns =
        std::max(static_cast<float>(kShortestNs), widest_mm_ / speed_ * kNanosecondsPerSecond);
    longest = std::min(longest, static_cast<std::uint32_t>(turning_ns));
  }
  if (left <= longest) return left;
  const std::uint32_t slices = (left + longest - 1) / longest;
  return (left + slices - 1) / slices;
}

/// Cuts the next slice. It ends with the stretch, at the end of the block, where an axis reverses,
/// or where the power changes, whichever comes first.
Segmenter::Cut Segmenter::cut_slice(std::uint32_t max_ns) {
  return cut(end_of_slice(std::min(reversals_.next(), power_.next_change()), max_ns));
}

/// Returns the end of the next slice. The slice ends at the position `stop`, or earlier if it would
/// last longer than longest_slice_ns() or `max_ns`.
Segmenter::End Segmenter::end_of_slice(PathUnits stop, std::uint32_t max_ns) {
  End end{.ns = stretch_.elapsed_ns() + std::min(longest_slice_ns(), max_ns)};
  end.place = stretch_.place_after(end.ns);
  if (end.place > stop) {
    end.ns = stretch_.time_after(stop - place_);
    end.place = stop;
  }
  return end;
}

void Segmenter::move_to(const MotorPath::Point& point) {
  for (const MotorPath::Motor& motor : path_.moving()) {
    place_steps_[motor.axis()] = motor.place(point);
  }
}

void Segmenter::pass_to_rest() {
  stretch_.end_at(place_);
  speed_ = 0.0F;
}

Segmenter::Cut Segmenter::cut(const End& end) {
  const std::uint32_t duration_ns = end.ns - stretch_.elapsed_ns();
  const float speed = stretch_.speed_after(end.ns);
  const std::uint64_t to_fraction = fraction_.of(end.place);
  if (observer_ != nullptr) {
    observer_->on_slice({blocks_ended_,
                         fraction_.of(place_),
                         to_fraction,
                         speed_,
                         stretch_.acceleration(),
                         static_cast<float>(duration_ns) * kSecondsPerNanosecond});
  }
  const Cut cut{.to = path_.at(to_fraction),
                .duration_ns = duration_ns,
                .start_speed = speed_,
                .duty = duties(speed_, speed)};
  speed_ = speed;
  if (kerf_.follows()) follow_kerf_to(end.place, to_fraction);
  place_ = end.place;
  reversals_.pass(place_);
  power_.pass(place_);
  stretch_.pass_until(end.ns);
  if (place_ == length_) end_block();
  return cut;
}

void Segmenter::follow_kerf_to(PathUnits end, std::uint64_t fraction) {
  if (kerf_.ends() && queue_.size() > 1) kerf_.meet(queue_.at(1));
  kerf_.move(fraction_of(fraction), to_mm(end - place_), heat(), limits_);
}

/// Returns the heat input divided by the programmed heat input. It is the ratio of the present to
/// the programmed power, divided by the ratio of the present to the programmed speed. Under M4 the
/// power follows the speed. Under M3 it is constant.
float Segmenter::heat() const {
  constexpr float kSlowest = 1.0e-3F;  // mm/s
  const Block& block = queue_.front();
  const float feed = kerf_.course().speed_mm_s();
  const float speed = std::max(speed_, kSlowest);
  const bool by_speed = block.beam.follows_speed && block.feed > 0.0F;
  const float heat = plan_.overrides().power * (feed / (by_speed ? block.feed : speed));
  // The power cannot exceed full power.
  return block.beam.duty > 0.0F ? std::min(heat, feed / (block.beam.duty * speed)) : heat;
}

bool Segmenter::power_follows_speed() const {
  const Block& block = queue_.front();
  return block.beam.follows_speed && block.feed > 0.0F;
}

/// Returns the duty at a path speed in mm/s, for the power at the present position.
float Segmenter::duty_at(float speed) const {
  if (power_.duty() <= 0.0F) return 0.0F;
  const auto duty_for = [this](float share) {
    return limits_.beam.table.duty_for(std::clamp(share, 0.0F, 1.0F));
  };
  const float share = power_.duty() * plan_.overrides().power;
  if (!power_follows_speed()) return duty_for(share);
  return std::max(duty_for(share * (speed / queue_.front().feed)), limits_.beam.min_duty);
}

Segmenter::Duties Segmenter::duties(float start_speed, float end_speed) const {
  const float start = duty_at(start_speed);
  const bool steady = start_speed == end_speed || !power_follows_speed();
  return {start, steady ? start : duty_at(end_speed)};
}

}  // namespace cnc::motion
