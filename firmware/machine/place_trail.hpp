#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "planner/motion/block/path_units.hpp"
#include "planner/motion/segment/segment.hpp"

namespace cnc {

/// How far along its path the motion is at which tick of the step clock, for the last 0.128 s of
/// motion, and until when it is lit.
///
/// While it is held the samples stay, and only the few that were still to come are added: so a tick
/// shortly after hold() is known for any time.
///
/// Samples are at least kSpacing apart and at most a segment more. Between them the distance is
/// taken as even: at an acceleration a it is off by at most a · (3 ms)² / 8, 6 µm at 5,000 mm/s².
class PlaceTrail {
 public:
  static constexpr std::size_t kSamples = 64;
  static constexpr std::uint32_t kSpacing = motion::kTicksPerSecond / 500;

  /// Forgets all; the motion is here.
  /// @param travelled running length in PathUnits, wraps
  void begin(std::uint32_t tick, std::uint64_t travelled);
  /// The motion is here at `tick`, and goes on from there. @param tick the last one's or later
  void add(std::uint32_t tick, std::uint64_t travelled);
  /// Keeps the present samples, or no longer.
  void hold(bool holds) { left_ = holds ? kComing : kAny; }
  /// Until this tick the output is lit somewhere.
  void note_light(std::uint32_t tick) { lit_until_ = tick; }

  /// Returns the distance from where the motion is at `tick` to `travelled`; from the nearest
  /// sample for ticks before or after all of them.
  [[nodiscard]] motion::PathUnits distance_since(std::uint32_t tick, std::uint64_t travelled) const;
  /// Returns whether the output is lit after `tick`.
  [[nodiscard]] bool is_lit_after(std::uint32_t tick) const { return after(lit_until_, tick) > 0; }

 private:
  /// Distances are kept in units of 2^-16 mm.
  static constexpr unsigned kCoarser = 20;
  /// Samples of 16 ms or more, while it is held.
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
  /// @param age 0 is the newest
  [[nodiscard]] const Sample& sample(std::size_t age) const {
    return samples_[(newest_ + kSamples - age) % kSamples];
  }

  std::array<Sample, kSamples> samples_{};
  std::size_t newest_ = 0;
  std::size_t count_ = 1;
  std::uint32_t lit_until_ = 0;
  std::uint32_t left_ = kAny;  ///< Samples that may be added.
};

}  // namespace cnc
