#include "planner/motion/segment/segment_power.hpp"

#include <algorithm>

#include "planner/motion/segment/power_course.hpp"

namespace cnc::motion {

std::uint16_t SegmentPower::Piece::output() const {
  const auto duration = static_cast<float>(std::max<std::uint32_t>(1, duration_ns));
  const float duty = std::clamp(energy_ns / duration, 0.0F, 1.0F);
  return static_cast<std::uint16_t>(duty * kFullOutput + 0.5F);
}

void SegmentPower::add(float start, float end, std::uint32_t duration_ns) {
  if (count_ == 0) start_ = start;
  jumps_ = jumps_ || (count_ > 0 && start != end_);
  end_ = end;
  const bool begins = count_ == 0 || (count_ < pieces_.size() && rate_.allows_short());
  if (begins) {
    pieces_[count_++] = {};
    rate_.begin();
  }
  rate_.pass(duration_ns);
  Piece& piece = pieces_[count_ - 1];
  piece.duration_ns += duration_ns;
  piece.energy_ns += 0.5F * (start + end) * static_cast<float>(duration_ns);
}

void SegmentPower::write(std::int32_t rest_ns, Segment& segment) const {
  segment.level_count = 0;
  if (!jumps_) {
    segment.power = power_course(start_, end_, segment.ticks);
    return;
  }
  segment.power = {.first = pieces_[0].output()};
  std::int32_t from_ns = rest_ns;
  std::uint32_t last = 0;
  for (std::size_t i = 1; i < count_; ++i) {
    from_ns += static_cast<std::int32_t>(pieces_[i - 1].duration_ns);
    const std::uint32_t from =
        static_cast<std::uint32_t>(std::max<std::int32_t>(0, from_ns)) / kNsPerTick;
    if (from >= segment.ticks) return;
    // A piece shorter than a tick is replaced by the next piece.
    if (from > last) segment.levels[segment.level_count++].from = static_cast<std::uint16_t>(from);
    last = from;
    const std::uint16_t output = pieces_[i].output();
    if (segment.level_count == 0) {
      segment.power.first = output;
    } else {
      segment.levels[segment.level_count - 1U].duty = output;
    }
  }
}

}  // namespace cnc::motion
