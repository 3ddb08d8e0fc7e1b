#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "planner/motion/block/path_units.hpp"
#include "planner/motion/segment/segment.hpp"

namespace cnc {

/// Samples of the latest motion, over at least 0.128 s: the distance that the motion has travelled
/// along its path, with its tick of the step clock. The trail also contains the tick until which
/// the beam is on.
///
/// hold(true) keeps the present samples. Then only kComing more samples are added, so that a tick
/// shortly after hold() is in the trail, too.
///
/// The time between two samples is at least kSpacing ticks, and exceeds kSpacing by at most one
/// segment. Between samples the distance is interpolated linearly. At an acceleration a the error
/// is at most a · (3 ms)² / 8, which is 6 µm at 5,000 mm/s².
class PlaceTrail {
 public:
  static constexpr std::size_t kSamples = 64;
  static constexpr std::uint32_t kSpacing = motion::kTicksPerSecond / 500;

  /// Drops all samples and adds the first new sample: at `tick`, the motion has travelled
  /// `travelled`.
  /// @param travelled running length of the path in PathUnits; wraps
  void begin(std::uint32_t tick, std::uint64_t travelled);
  /// Adds a sample: at `tick` the motion has `travelled` so far.
  /// @param tick at or after the tick of the last sample
  void add(std::uint32_t tick, std::uint64_t travelled);
  /// If `holds`, keeps the present samples from now on. Otherwise new samples replace the oldest
  /// again.
  void hold(bool holds) { left_ = holds ? kComing : kAny; }
  /// Notes that the beam is on until `tick`, with or without interruptions.
  void note_light(std::uint32_t tick) { lit_until_ = tick; }

  /// Returns the length of the path from its point at `tick` to its point at `travelled`. For a
  /// tick before or after all samples, the nearest sample is used.
  [[nodiscard]] motion::PathUnits distance_since(std::uint32_t tick, std::uint64_t travelled) const;
  /// Returns whether the beam is on at any time after `tick`.
  [[nodiscard]] bool is_lit_after(std::uint32_t tick) const { return after(lit_until_, tick) > 0; }

 private:
  /// Number of bits by which PathUnits are shifted to the unit of the samples, 2^-16 mm.
  static constexpr unsigned kCoarser = 20;
  /// Samples that may still be added while the trail is held: 16 ms or more.
  static constexpr std::uint32_t kComing = 8;
  static constexpr std::uint32_t kAny = ~std::uint32_t{0};

  struct Sample {
    std::uint32_t tick = 0;
    std::uint32_t place = 0;
  };

  static std::uint32_t coarse(std::uint64_t travelled) {
    return static_cast<std::uint32_t>(travelled >> kCoarser);
  }
  static std::int32_t after(std::uint32_t a, std::uint32_t b) {
    return static_cast<std::int32_t>(a - b);
  }
  /// Returns a sample.
  /// @param age 0 is the newest
  [[nodiscard]] const Sample& sample(std::size_t age) const {
    return samples_[(newest_ + kSamples - age) % kSamples];
  }

  std::array<Sample, kSamples> samples_{};
  std::size_t newest_ = 0;
  std::size_t count_ = 1;
  std::uint32_t lit_until_ = 0;
  std::uint32_t left_ = kAny;  ///< Number of samples that may still be added.
};

}  // namespace cnc
