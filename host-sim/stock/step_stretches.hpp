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
  kJoint,  ///< Position at the joint between a rapid and a feed. It may belong to either motion.
};

/// Program line and kind of the motion to which a stretch belongs.
struct StretchOrigin {
  int line = 0;  ///< Number of the program line; 0 before the first line.
  Drive drive = Drive::kFeed;

  bool operator==(const StretchOrigin&) const = default;
};

/// A stretch of the driven path with the time of its end.
struct DrivenStretch {
  Stretch stretch;
  StretchOrigin origin;
  double end_s = 0.0;
};

/// Joins the steps of a tool to straight stretches while all positions are within a tolerance of
/// the stretch in space. Between two positions the tool moves straight. Stretches begin and end at
/// positions of the tool. Each stretch states the tool's greatest deviation from it. The slack to
/// the side is rounded up to quarters of the tolerance; the slack in height is exact.
class StepStretches {
 public:
  using Sink = std::function<void(const DrivenStretch&)>;

  /// @param tolerance_mm greatest distance of a step from its stretch, > 0. It should be a few
  ///     steps long; with a smaller tolerance, each step becomes a stretch
  StepStretches(double tolerance_mm, Sink sink)
      : tolerance_mm_{tolerance_mm}, sink_{std::move(sink)} {}

  /// Adds a step to a position; the first call sets the start. All steps of a stretch have the same
  /// origin.
  void go_to(const Pose& pose, const StretchOrigin& origin, double time_s);
  /// Passes the remaining steps to the sink.
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
  /// Greatest number of positions in a stretch. The limit lets long lines be carved while they are
  /// driven.
  static constexpr std::size_t kMaxSteps = 1 << 15;

  [[nodiscard]] std::optional<Offset> fit(std::size_t count) const;
  void hand_out(std::size_t count);
  void hand_out_longest(std::size_t fitting, std::size_t too_many);
  void settle(bool all);

  double tolerance_mm_;
  Sink sink_;
  std::optional<Pose> start_;
  StretchOrigin origin_;
  std::vector<Step> steps_;   ///< Steps since the start of the stretch.
  std::size_t to_check_ = 2;  ///< Number of waiting steps at which settle() next checks their fit.
};

}  // namespace sim::stock
