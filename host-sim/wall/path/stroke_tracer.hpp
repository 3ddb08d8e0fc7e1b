#pragma once

#include <Eigen/Core>
#include <numbers>
#include <optional>
#include <vector>

#include "host-sim/wall/layer/layer_strokes.hpp"
#include "host-sim/wall/path/beam_finder.hpp"
#include "host-sim/wall/path/rotary_words.hpp"

namespace sim::wall {

/// Successive poses of the beam. The beam is on from the first pose to the last. A run also
/// contains the lost tips before its first pose, which are out of reach.
struct BeamRun {
  StrokeUse use = StrokeUse::kHatch;
  std::vector<Eigen::Vector3d> lost;
  std::vector<TipBeam> beams;  ///< Poses of the beam; at least two, or none.
};

/// Limits for the rotation of the beam's axis along a stroke.
struct TurnRules {
  RotaryAxes axes = RotaryAxes::kAC;
  double step_mm = 0.0;  ///< Maximum distance between tips next to a wall, above 0.
  /// Maximum turn of the axis per mm where the part leaves enough space.
  double turn_rate_rad_per_mm = 0.0;
  /// Jump of the axis of least tilt, in radians, above which the axis turns with the beam off.
  double swing_rad = 3.0 * std::numbers::pi / 180.0;
  /// Maximum depth by which the beam may be inside the part between tips.
  double depth_mm = 1.0e-3;
};

/// Finds a beam for each tip of a stroke, so that the axis turns no faster than the rules allow.
///
/// Tips are at the ends of all sides of the stroke. Between the ends, their spacing is as small as
/// the rotation of the axis requires. If the axis of least tilt turns too fast at a point, the axes
/// before and after this point lean more. Their beams must still clear the part. If walls leave no
/// space for more lean, the axis turns faster. If the axis jumps, the run ends, and the axis turns
/// with the beam off. The next run begins within twice kGapMm.
class StrokeTracer {
 public:
  /// Maximum distance between neighbouring tips at which a run ends and the next run begins, mm.
  static constexpr double kGapMm = 2.0e-3;

  StrokeTracer(const BeamFinder& finder, const TurnRules& rules) : finder_{finder}, rules_{rules} {}

  /// Returns the runs of a stroke whose tips are at `height_mm`. If the stroke ends with tips out
  /// of reach, the last run contains only these tips, and no beams.
  [[nodiscard]] std::vector<BeamRun> runs_of(const Stroke& stroke, double height_mm) const;

 private:
  /// A tip with its beam; the beam is empty if the tip is out of reach.
  struct Sample {
    Eigen::Vector3d tip = Eigen::Vector3d::Zero();
    double free_mm = 0.0;  ///< Distance by which the tip may move while the beam stays upright, mm.
    std::optional<TipBeam> beam;
  };
  using Samples = std::vector<Sample>;
  using Flags = std::vector<bool>;

  [[nodiscard]] Sample sample_at(const Eigen::Vector3d& tip, double max_mm) const;
  void add_side(const Eigen::Vector3d& from, const Eigen::Vector3d& to, Samples& samples) const;
  [[nodiscard]] bool turns_slowly(const Sample& from, const Sample& to) const;
  [[nodiscard]] bool is_clear_between(const Sample& from, const Sample& to) const;
  [[nodiscard]] bool is_joined(const Sample& from, const Sample& to) const;
  [[nodiscard]] bool is_jump(const Sample& from, const Sample& to) const;
  void lean_towards(const Sample& other, Sample& sample) const;
  [[nodiscard]] Samples smoothed(const Samples& least) const;
  [[nodiscard]] Flags joints_of(const Samples& samples) const;
  [[nodiscard]] Flags small_turns_of(const Samples& least) const;
  [[nodiscard]] bool refine(const Flags& is_joined, Samples& samples) const;
  [[nodiscard]] static std::vector<BeamRun> runs_between(const Samples& samples,
                                                         const Flags& joints,
                                                         StrokeUse use);

  BeamFinder finder_;
  TurnRules rules_;
};

}  // namespace sim::wall
