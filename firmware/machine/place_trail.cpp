#include "firmware/machine/place_trail.hpp"

#include <algorithm>

namespace cnc {

void PlaceTrail::begin(std::uint32_t tick, std::uint64_t travelled) {
  count_ = 1;
  samples_[newest_] = {.tick = tick, .place = coarse(travelled)};
  lit_until_ = tick;
}

void PlaceTrail::add(std::uint32_t tick, std::uint64_t travelled) {
  constexpr std::int32_t kLongAgo = std::int32_t{1} << 30;
  // The tick counter wraps, so a tick of the distant past would otherwise count as a future tick.
  if (after(tick, lit_until_) > kLongAgo) lit_until_ = tick - kLongAgo;
  const bool close =
      count_ > 1 && after(sample(0).tick, sample(1).tick) < static_cast<std::int32_t>(kSpacing);
  if (!close && tick != sample(0).tick) {
    if (left_ == 0) return;
    if (left_ != kAny) --left_;
    newest_ = (newest_ + 1) % kSamples;
    count_ = std::min(count_ + 1, kSamples);
  }
  samples_[newest_] = {.tick = tick, .place = coarse(travelled)};
}

motion::PathUnits PlaceTrail::distance_since(std::uint32_t tick, std::uint64_t travelled) const {
  std::size_t age = 0;
  while (age + 1 < count_ && after(sample(age).tick, tick) > 0) ++age;
  std::uint32_t place = sample(age).place;
  const std::int32_t since = after(tick, sample(age).tick);
  if (age > 0 && since > 0) {
    const Sample& later = sample(age - 1);
    const auto whole = static_cast<float>(after(later.tick, sample(age).tick));
    const auto between = static_cast<float>(later.place - place);
    place += static_cast<std::uint32_t>(between * (static_cast<float>(since) / whole));
  }
  return motion::PathUnits{coarse(travelled) - place} << kCoarser;
}

}  // namespace cnc
