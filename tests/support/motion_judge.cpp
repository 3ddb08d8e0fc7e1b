#include "tests/support/motion_judge.hpp"

#include <algorithm>
#include <cmath>

namespace sim {
namespace {

constexpr double kSamplePeriod = 50.0e-6;  // s

void note(WorstFigure& worst, double value, const WorstFigure& where) {
  if (!(value > worst.value)) return;
  worst = where;
  worst.value = value;
}

class MotionJudge {
 public:
  MotionJudge(const FilteredPlan& plan, const ProgrammedPath& path, const MotionLimits& limits)
      : plan_{plan}, path_{path}, limits_{limits} {}

  MotionFigures run() {
    figures_.gap = plan_.greatest_gap();
    figures_.end_error = std::abs(plan_.at(plan_.seconds()).place - path_.length());
    const std::vector<double> times = plan_.breakpoints();
    for (std::size_t i = 0; i + 1 < times.size(); ++i) judge_stretch(times[i], times[i + 1]);
    return figures_;
  }

 private:
  [[nodiscard]] const PathPiece& piece() const { return path_.pieces[piece_]; }
  [[nodiscard]] double piece_end() const { return piece_start_ + piece().curve.length(); }
  [[nodiscard]] bool last_piece() const { return piece_ + 1 == path_.pieces.size(); }

  /// Judges the time between two breakpoints, in which the jerk is constant.
  void judge_stretch(double from, double to) {
    jerk_ = plan_.at(0.5 * (from + to)).jerk;
    while (!last_piece() && plan_.at(to).place >= piece_end()) {
      const double crossing = time_at(piece_end(), from, to);
      judge_on_piece(from, crossing);
      pass_joint(crossing);
      from = crossing;
    }
    judge_on_piece(from, to);
  }

  [[nodiscard]] double time_at(double place, double from, double to) const {
    constexpr int kHalvings = 60;
    for (int i = 0; i < kHalvings; ++i) {
      const double middle = 0.5 * (from + to);
      (plan_.at(middle).place < place ? from : to) = middle;
    }
    return to;
  }

  void judge_on_piece(double from, double to) {
    judge_moment(from);
    const double first = std::floor(from / kSamplePeriod) + 1.0;
    for (double k = first; k * kSamplePeriod < to; k += 1.0) judge_moment(k * kSamplePeriod);
    judge_moment(to);
  }

  void judge_moment(double time) {
    const PathState state = plan_.at(time);
    const Curve& curve = piece().curve;
    if (curve.length() <= 0.0) return;
    const double fraction = std::clamp((state.place - piece_start_) / curve.length(), 0.0, 1.0);
    const Point tangent = curve.tangent_at(fraction);
    const Point bend = curve.curvature_at(fraction);
    const Point twist = curvature_rate_at(curve, fraction);
    const double v = state.speed;
    WorstFigure here{.time = time, .place = state.place, .piece = piece_};
    note(figures_.feed, v / piece().path_feed(), here);
    for (std::size_t i = 0; i < tangent.size(); ++i) {
      here.axis = i;
      const double acceleration = tangent[i] * state.acceleration + bend[i] * v * v;
      const double jerk =
          tangent[i] * jerk_ + 3.0 * bend[i] * v * state.acceleration + twist[i] * v * v * v;
      note(figures_.rate, std::abs(tangent[i]) * v / limits_.rate[i], here);
      note(figures_.acceleration, std::abs(acceleration) / limits_.acceleration[i], here);
      note(figures_.jerk, std::abs(jerk) / limits_.jerk[i], here);
    }
  }

  void pass_joint(double time) {
    const Curve& before = piece().curve;
    piece_start_ = piece_end();
    ++piece_;
    const Curve& after = piece().curve;
    const double v = plan_.at(time).speed;
    WorstFigure here{.time = time, .place = piece_start_, .piece = piece_};
    if (piece().stop_before) note(figures_.stop, v, here);
    const Point turn = after.tangent_at(0.0) - before.tangent_at(1.0);
    const Point bend = after.curvature_at(0.0) - before.curvature_at(1.0);
    for (std::size_t i = 0; i < turn.size(); ++i) {
      here.axis = i;
      note(figures_.turn, std::abs(turn[i]) * v, here);
      note(figures_.step, std::abs(bend[i]) * v * v / limits_.acceleration[i], here);
    }
  }

  const FilteredPlan& plan_;
  const ProgrammedPath& path_;
  const MotionLimits& limits_;
  MotionFigures figures_{};
  std::size_t piece_ = 0;
  double piece_start_ = 0.0;  ///< Start of the present piece, mm along the path.
  double jerk_ = 0.0;         ///< Jerk of the present stretch, mm/s³.
};

}  // namespace

MotionFigures judge_motion(const FilteredPlan& plan,
                           const ProgrammedPath& path,
                           const MotionLimits& limits) {
  return MotionJudge{plan, path, limits}.run();
}

Point curvature_rate_at(const Curve& curve, double fraction) {
  Point rate{};
  if (!curve.circle() || curve.length() <= 0.0) return rate;
  // In the plane the tangent turns at a constant rate: t″ = −(sweep / length)² t.
  const PlaneVectors& plane = curve.circle()->vectors;
  const double turn = curve.circle()->sweep / curve.length();
  rate = plane.vector(plane.seen(curve.tangent_at(fraction)));
  for (double& share : rate) share *= -turn * turn;
  return rate;
}

}  // namespace sim
