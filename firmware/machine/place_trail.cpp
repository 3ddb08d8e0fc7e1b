#include "firmware/machine/place_trail.hpp"

#include <algorithm>

#include "planner/base/truncate.hpp"

namespace cnc {

void PlaceTrail::begin(std::uint32_t tick, std::uint64_t travelled) {
  count_ = 1;
  samples_[newest_] = {.tick = tick, .place = static_cast<std::uint32_t>(travelled >> kCoarser)};
  lit_until_ = tick;
}

void PlaceTrail::add(std::uint32_t tick, std::uint64_t travelled) {
  constexpr std::int32_t kLongAgo = std::int32_t{1} << 30;
  const bool close = count_ > 1 && after(tick, sample(1).tick) < static_cast<int>(kSpacing);
  if (!close && tick != sample(0).tick) {
    newest_ = (newest_ + 1) % kSamples;
    count_ = std::min(count_ + 1, kSamples);
  }
  samples_[newest_] = {.tick = tick, .place = static_cast<std::uint32_t>(travelled >> kCoarser)};
  // So that a tick of long ago is never taken for one that is yet to come.
  if (after(tick, lit_until_) > kLongAgo) lit_until_ = tick - kLongAgo;
}

motion::PathUnits PlaceTrail::distance_since(std::uint32_t tick) const {
  const Sample& newest = sample(0);
  std::size_t age = 0;
  while (age < count_ && after(sample(age).tick, tick) > 0) ++age;
  if (age == 0) return 0;
  const Sample& later = sample(age - 1);
  std::uint32_t distance = newest.place - later.place;
  if (age < count_) {
    const Sample& earlier = sample(age);
    const auto part = static_cast<float>(after(later.tick, tick)) /
                      static_cast<float>(after(later.tick, earlier.tick));
    const std::uint32_t between = later.place - earlier.place;
    distance += static_cast<std::uint32_t>(truncated(part * static_cast<float>(between) + 0.5F));
  }
  return static_cast<motion::PathUnits>(std::uint64_t{distance} << kCoarser);
}

}  // namespace cnc
