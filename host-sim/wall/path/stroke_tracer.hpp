#pragma once

#include <Eigen/Core>
#include <numbers>
#include <optional>
#include <vector>

#include "host-sim/wall/layer/layer_strokes.hpp"
#include "host-sim/wall/path/beam_finder.hpp"
#include "host-sim/wall/path/rotary_words.hpp"

namespace sim::wall {

/// Successive beams with the beam on from the first to the last, and the tips before them that are
/// out of reach.
struct BeamRun {
  StrokeUse use = StrokeUse::kHatch;
  std::vector<Eigen::Vector3d> lost;
  std::vector<TipBeam> beams;  ///< At least two beams, or none.
};

/// Limits for the turning of beams along a stroke.
struct TurnRules {
  RotaryAxes axes = RotaryAxes::kAC;
  double step_mm = 0.0;  ///< Maximum distance between tips next to a wall, above 0.
  /// Maximum change of the axis where the part leaves enough space.
  double turn_rate_rad_per_mm = 0.0;
  /// If the axis of least tilt jumps by more than this angle, the beam swings while it is off.
  double swing_rad = 3.0 * std::numbers::pi / 180.0;
  double depth_mm = 1.0e-3;  ///< Maximum depth of a beam in the part between tips.
};

/// Gives each tip of a stroke its beam, so that the axis turns no faster than the rules allow.
///
/// Tips are at the ends of all sides of the stroke, and between them as densely as the axis needs.
/// If the axis of least tilt turns too fast, the axes before and after that place lean more, as
/// long as their beams clear the part. If walls leave no space for that, the axis turns faster, as
/// the part requires. If the axis jumps, the run ends, and the next run begins within two gaps: the
/// beam swings while it is off.
class StrokeTracer {
 public:
  /// Maximum distance between neighbouring tips that no run joins, mm.
  static constexpr double kGapMm = 2.0e-3;

  StrokeTracer(const BeamFinder& finder, const TurnRules& rules) : finder_{finder}, rules_{rules} {}

  /// Returns the runs of a stroke at a height. The last run may have only lost tips.
  [[nodiscard]] std::vector<BeamRun> runs_of(const Stroke& stroke, double height_mm) const;

 private:
  /// A tip, with its beam of least tilt if there is one.
  struct Sample {
    Eigen::Vector3d tip = Eigen::Vector3d::Zero();
    double free_mm = 0.0;  ///< Distance by which the tip may move with an upright beam.
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
