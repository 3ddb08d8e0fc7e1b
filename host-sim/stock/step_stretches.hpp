#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "host-sim/stock/carver.hpp"

namespace sim::stock {

enum class Drive : std::uint8_t {
  kFeed,
  kRapid,
  kJoint,  ///< The end of a rapid at a feed, where either may be meant.
};

/// The motion of the program that drives a stretch.
struct StretchOrigin {
  int line = 0;  ///< 0 before the first.
  Drive drive = Drive::kFeed;

  bool operator==(const StretchOrigin&) const = default;
};

/// A stretch of the driven path with the time of its end.
struct DrivenStretch {
  Stretch stretch;
  StretchOrigin origin;
  double end_s = 0.0;
};

/// Gathers the steps of a tool to straight stretches, as long as its positions are within a
/// tolerance of them, in space; between two positions it goes straight. Stretches begin and end at
/// positions of the tool, and state how far it is off them: the slack to the side in quarters of
/// the tolerance, the slack in height as it is.
class StepStretches {
 public:
  using Sink = std::function<void(const DrivenStretch&)>;

  /// @param tolerance_mm > 0; a few steps at least, or stretches are as short as steps
  StepStretches(double tolerance_mm, Sink sink)
      : tolerance_mm_{tolerance_mm}, sink_{std::move(sink)} {}

  /// The tool goes to a position, or starts there. Stretches have one origin only.
  void go_to(const Pose& pose, const StretchOrigin& origin, double time_s);
  /// Hands out the remaining steps.
  void finish();

 private:
  struct Step {
    Pose pose;
    double time_s = 0.0;
  };
  struct Offset {
    double side_mm = 0.0;
    double up_mm = 0.0;
  };
  /// Positions in one stretch, so that long lines are carved while they are driven.
  static constexpr std::size_t kMostSteps = 1 << 15;

  [[nodiscard]] std::optional<Offset> fit(std::size_t count) const;
  void hand_out(std::size_t count);
  void hand_out_longest(std::size_t fitting, std::size_t too_many);
  void settle(bool all);

  double tolerance_mm_;
  Sink sink_;
  std::optional<Pose> start_;
  StretchOrigin origin_;
  std::vector<Step> steps_;   ///< Since the start.
  std::size_t to_check_ = 2;  ///< Number of waiting steps at which they are checked.
};

}  // namespace sim::stock
