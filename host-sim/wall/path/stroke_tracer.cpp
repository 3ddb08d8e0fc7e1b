#include "host-sim/wall/path/stroke_tracer.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "host-sim/wall/axis_angle.hpp"
#include "planner/base/wide_scalar_math.hpp"

namespace sim::wall {
namespace {

using Eigen::Vector3d;

/// Rounding error of angles, radians.
constexpr double kAngleRounding = 1.0e-9;
/// Rounding error of distances, mm.
constexpr double kStrokeRoundingMm = 1.0e-9;

bool is_upright(const TipBeam& beam) { return beam.axis == Vector3d::UnitZ(); }

}  // namespace

StrokeTracer::Sample StrokeTracer::sample_at(const Vector3d& tip, double max_mm) const {
  if (!finder_.rules().avoids) return {.tip = tip, .free_mm = max_mm, .beam = TipBeam{.tip = tip}};
  const double clearance = finder_.upright_clearance(tip, max_mm);
  if (clearance >= -kStrokeRoundingMm) {
    return {.tip = tip, .free_mm = std::max(0.0, clearance), .beam = TipBeam{.tip = tip}};
  }
  return {.tip = tip, .free_mm = 0.0, .beam = finder_.leaning(tip)};
}

/// Appends the tips of a stroke's side, except the first tip. The spacing is the clearance of the
/// upright beam, but at least the step.
void StrokeTracer::add_side(const Vector3d& from, const Vector3d& to, Samples& samples) const {
  const double length = (to - from).norm();
  const Vector3d way = (to - from) / length;
  double done = 0.0;
  while (done < length) {
    const double step = std::max(rules_.step_mm, samples.back().free_mm);
    // Divides the rest of the side equally into the last two steps, so that no step is tiny.
    const double left = length - done;
    const double next = left <= step ? left : std::min(step, std::max(0.5 * left, kGapMm));
    done = next == left ? length : done + next;
    // Within the side, the remaining length limits the clearance. At the end of the side, the limit
    // is the length of the complete side, because the next side begins with this sample.
    const bool is_end = done == length;
    samples.push_back(
        sample_at(is_end ? to : Vector3d{from + done * way}, is_end ? length : length - done));
  }
}

bool StrokeTracer::turns_slowly(const Sample& from, const Sample& to) const {
  const double most = rules_.turn_rate_rad_per_mm * (to.tip - from.tip).norm();
  return angle_between(from.beam->axis, to.beam->axis) <= most + kAngleRounding;
}

/// Returns whether the beam clears the part at the quarters of the path between two tips, while the
/// rotary axes turn linearly.
bool StrokeTracer::is_clear_between(const Sample& from, const Sample& to) const {
  const double length = (to.tip - from.tip).norm();
  const bool are_upright = is_upright(*from.beam) && is_upright(*to.beam);
  if (are_upright && from.free_mm + to.free_mm >= length - kStrokeRoundingMm) return true;
  RotaryWords begin = first_words_of(rules_.axes, from.beam->axis);
  if (begin.tilt == 0.0) begin.turn = first_words_of(rules_.axes, to.beam->axis).turn;
  const RotaryWords end = words_of(rules_.axes, to.beam->axis, begin);
  // If the beam hardly rotates, a check at the middle of the path is sufficient.
  constexpr double kStill = 0.01;
  const bool is_still = angle_between(from.beam->axis, to.beam->axis) <= kStill;
  return std::ranges::all_of(std::array{0.5, 0.25, 0.75}, [&](double share) {
    if (is_still && share != 0.5) return true;
    const RotaryWords words{begin.tilt + share * (end.tilt - begin.tilt),
                            begin.turn + share * (end.turn - begin.turn)};
    return finder_.is_clear(
        {.tip = from.tip + share * (to.tip - from.tip), .axis = axis_of(rules_.axes, words)},
        rules_.depth_mm);
  });
}

bool StrokeTracer::is_joined(const Sample& from, const Sample& to) const {
  if (!from.beam && !to.beam) return true;
  if (!from.beam || !to.beam) return false;
  if (!finder_.rules().avoids) return true;
  // If the beam overlaps the part, each tip has only one axis of least overlap. The beam must
  // follow these axes, even if they turn fast.
  if (from.beam->left_rad > 0.0 || to.beam->left_rad > 0.0) return true;
  // If walls leave no space to turn slowly, the beam stays on and the machine slows down.
  const bool is_short = (to.tip - from.tip).norm() <= kGapMm;
  const bool may_turn =
      turns_slowly(from, to) ||
      (is_short && angle_between(from.beam->axis, to.beam->axis) <= rules_.swing_rad);
  return may_turn && is_clear_between(from, to);
}

/// Turns the beam of `sample` towards the beam of `other`, whose tilt is at least as great. Tries
/// two wanted axes: the axis nearest to the beam's present axis from which the rate allows the turn
/// to the other axis, and the other axis itself. The new axis is the clear axis nearest to a wanted
/// axis.
void StrokeTracer::lean_towards(const Sample& other, Sample& sample) const {
  if (!sample.beam || !other.beam || turns_slowly(sample, other)) return;
  const Vector3d& axis = sample.beam->axis;
  const Vector3d& goal = other.beam->axis;
  if (goal.z() > axis.z() + kAngleRounding) return;
  if (sample.beam->left_rad > 0.0 || other.beam->left_rad > 0.0) return;
  const double most = rules_.turn_rate_rad_per_mm * (other.tip - sample.tip).norm();
  const cnc::WideSinCos turn = cnc::sin_cos(most);
  const Vector3d pole = goal.cross(axis).normalized();
  const Vector3d nearest = (turn.cosine * goal + turn.sine * pole.cross(goal)).normalized();
  std::optional<TipBeam> best = sample.beam;
  for (const Vector3d& wanted : {nearest, goal}) {
    const std::optional<TipBeam> moved = finder_.nearest_to(wanted, sample.tip);
    if (!moved) continue;
    const double angle = angle_between(moved->axis, goal);
    const bool is_nearer = angle < angle_between(best->axis, goal) - kAngleRounding;
    if (is_nearer) best = moved;
    if (angle <= most + kAngleRounding) break;
  }
  sample.beam = best;
}

/// Returns whether the axis of least tilt jumps between two samples, because another wall
/// determines it at the second sample. The tilts of both axes are then about equal.
bool StrokeTracer::is_jump(const Sample& from, const Sample& to) const {
  if (!from.beam || !to.beam || (to.tip - from.tip).norm() > kGapMm) return false;
  constexpr double kSameTilt = 0.1;
  const Vector3d up = Vector3d::UnitZ();
  const double difference =
      std::abs(angle_between(from.beam->axis, up) - angle_between(to.beam->axis, up));
  return angle_between(from.beam->axis, to.beam->axis) > rules_.swing_rad &&
         difference <= kSameTilt * rules_.swing_rad;
}

StrokeTracer::Samples StrokeTracer::smoothed(const Samples& least) const {
  Samples samples = least;
  if (!finder_.rules().avoids) return samples;
  for (std::size_t i = samples.size() - 1; i > 0; --i) {
    if (!is_jump(least[i - 1], least[i])) lean_towards(samples[i], samples[i - 1]);
  }
  for (std::size_t i = 1; i < samples.size(); ++i) {
    if (!is_jump(least[i - 1], least[i])) lean_towards(samples[i - 1], samples[i]);
  }
  return samples;
}

/// Returns, for each sample except the last, whether the beam may stay on up to the next sample.
StrokeTracer::Flags StrokeTracer::joints_of(const Samples& samples) const {
  Flags joints(samples.size() - 1);
  for (std::size_t i = 0; i < joints.size(); ++i) joints[i] = is_joined(samples[i], samples[i + 1]);
  return joints;
}

/// Returns, for each sample except the last, whether the axis of least tilt turns by at most
/// `swing_rad` up to the next sample.
StrokeTracer::Flags StrokeTracer::small_turns_of(const Samples& least) const {
  Flags are_small(least.size() - 1, true);
  for (std::size_t i = 0; i < are_small.size(); ++i) {
    if (!least[i].beam || !least[i + 1].beam) continue;
    const double angle = angle_between(least[i].beam->axis, least[i + 1].beam->axis);
    are_small[i] = angle <= rules_.swing_rad;
  }
  return are_small;
}

/// Inserts a tip between neighbours that are not joined and whose distance exceeds kGapMm.
/// @return whether a tip was inserted
bool StrokeTracer::refine(const Flags& is_joined, Samples& samples) const {
  Samples finer;
  finer.reserve(samples.size() + 8);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    finer.push_back(samples[i]);
    if (i + 1 == samples.size() || is_joined[i]) continue;
    const double length = (samples[i + 1].tip - samples[i].tip).norm();
    if (length <= kGapMm) continue;
    finer.push_back(sample_at(0.5 * (samples[i].tip + samples[i + 1].tip), length));
  }
  const bool has_more = finer.size() > samples.size();
  samples = std::move(finer);
  return has_more;
}

std::vector<BeamRun> StrokeTracer::runs_of(const Stroke& stroke, double height_mm) const {
  const auto tip = [&](std::size_t i) {
    return Vector3d{stroke.places[i].x(), stroke.places[i].y(), height_mm};
  };
  Samples least{sample_at(tip(0), (tip(1) - tip(0)).norm())};
  for (std::size_t i = 1; i < stroke.places.size(); ++i) add_side(tip(i - 1), tip(i), least);
  while (refine(small_turns_of(least), least)) {
  }
  Samples samples = smoothed(least);
  Flags joints = joints_of(samples);
  while (refine(joints, least)) {
    samples = smoothed(least);
    joints = joints_of(samples);
  }
  return runs_between(samples, joints, stroke.use);
}

/// Divides samples into runs. A run has at least two beams. A single tip between two runs is also
/// lost, unless its distance from a run is at most kGapMm.
std::vector<BeamRun> StrokeTracer::runs_between(const Samples& samples,
                                                const Flags& joints,
                                                StrokeUse use) {
  const auto is_joint = [&joints](std::size_t i) { return i < joints.size() && joints[i]; };
  const auto is_beside_run = [&](std::size_t i) {
    const auto is_near = [&](std::size_t other) {
      return (samples[i].tip - samples[other].tip).norm() <= kGapMm;
    };
    return (i > 1 && is_joint(i - 2) && samples[i - 1].beam && is_near(i - 1)) ||
           (is_joint(i + 1) && samples[i + 1].beam && is_near(i + 1));
  };
  std::vector<BeamRun> runs{{.use = use, .lost = {}, .beams = {}}};
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const bool has_before = i > 0 && joints[i - 1];
    const bool is_alone = !has_before && !is_joint(i);
    if (!has_before && !runs.back().beams.empty()) runs.push_back({use, {}, {}});
    if (samples[i].beam && !is_alone) {
      runs.back().beams.push_back(*samples[i].beam);
    } else if (!samples[i].beam || !is_beside_run(i)) {
      runs.back().lost.push_back(samples[i].tip);
    }
  }
  return runs;
}

}  // namespace sim::wall
