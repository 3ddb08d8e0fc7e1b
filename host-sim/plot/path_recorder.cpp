#include "host-sim/plot/path_recorder.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "planner/base/contract.hpp"

namespace sim {
namespace {

/// Greatest number of rows in a window. The limit ends a window in which the path makes no
/// progress, for example because a motor moves to and fro.
constexpr std::size_t kMaxSamples = 4'096;

/// Number of steps into which the greatest speed is divided. Speeds that differ by less than a step
/// look the same, because a step is half as wide as a colour of the legend.
constexpr float kSpeedSteps = 64.0F;

double coarsest_step_mm(const cnc::AxisArray<float>& steps_per_mm) {
  CNC_ASSERT(steps_per_mm[0] > 0.0F && steps_per_mm[1] > 0.0F && steps_per_mm[2] > 0.0F);
  return 1.0 / std::min<double>(steps_per_mm[0], steps_per_mm[1]);
}

PathTolerance first_tolerance(double step_mm) {
  return {.distance_mm = std::max(PathTolerance{}.distance_mm, 2.0 * step_mm), .speed_mm_s = 0.0F};
}

}  // namespace

PathRecorder::PathRecorder(const cnc::AxisArray<float>& steps_per_mm, Shown shown)
    : shown_{shown},
      window_{coarsest_step_mm(steps_per_mm)},
      simplifier_{first_tolerance(coarsest_step_mm(steps_per_mm))} {
  for (std::size_t axis = 0; axis < cnc::kLinearAxisCount; ++axis) {
    mm_per_step_[axis] = 1.0 / static_cast<double>(steps_per_mm[axis]);
  }
  samples_.reserve(kMaxSamples);
}

void PathRecorder::on_row(const TraceRow& row) {
  if (!has_started_) return start(row);
  const bool stood_still = row.time_ns - window_.last_ns() >= SpeedWindow::kStandstillNs;
  if (stood_still) come_to_rest();
  const SpeedWindow::Point point = point_between(position_, row.position);
  window_.move_to(row.time_ns, point);
  last_move_ = move_of_stretch();
  add_sample(point);
  position_ = row.position;
  duty_ = row.duty;
  if (stood_still || window_.is_full() || samples_.size() == kMaxSamples) close_window();
}

void PathRecorder::on_end(std::uint64_t time_ns) {
  if (has_started_) come_to_rest();
  path_.vertices = simplifier_.finish();
  if (shown_ == Shown::kDepth) measure_depths();
  path_.shown = shown_;
  path_.duration_s = 1e-9 * static_cast<double>(time_ns);
}

// Returns the kind of the motion from the last row to the present row. The output of the last row
// was in effect during this motion.
Move PathRecorder::move_of_stretch() const {
  if (is_rapid_.value_or(false)) return Move::kTravel;
  if (duty_ > 0.0F) return Move::kCut;
  return is_rapid_ ? Move::kFeed : Move::kTravel;
}

// Returns the midpoint of two consecutive positions. A motor steps when the path is half way
// between two of its positions. Therefore the midpoint is nearer to the path than either position,
// which halves the error of the staircase.
SpeedWindow::Point PathRecorder::point_between(const Position& before,
                                               const Position& after) const {
  const auto middle_mm = [&](std::size_t axis) {
    const double sum = static_cast<double>(before[axis]) + static_cast<double>(after[axis]);
    return 0.5 * sum * mm_per_step_[axis];
  };
  return {middle_mm(0), middle_mm(1), middle_mm(2)};
}

void PathRecorder::start(const TraceRow& row) {
  position_ = row.position;
  duty_ = row.duty;
  const SpeedWindow::Point point = point_between(position_, position_);
  window_.restart(row.time_ns, point);
  simplifier_.push({.x_mm = point.x_mm, .y_mm = point.y_mm});
  has_started_ = true;
}

void PathRecorder::add_sample(const SpeedWindow::Point& point) {
  const bool stays =
      !samples_.empty() && samples_.back().x_mm == point.x_mm && samples_.back().y_mm == point.y_mm;
  const float value = shown_ == Shown::kPower ? duty_ : static_cast<float>(point.z_mm);
  if (!stays) samples_.push_back({point.x_mm, point.y_mm, last_move_, value});
}

void PathRecorder::come_to_rest() {
  const SpeedWindow::Point point = point_between(position_, position_);
  window_.move_to(window_.last_ns(), point);
  add_sample(point);
  close_window();
}

// Converts heights to depths. They are measured from Z0 if a cut is below Z0, otherwise from the
// highest cut. Plunges through air and links above the work look like cuts. Therefore cuts count by
// their length along X and Y, and the highest hundredth of this length is ignored.
void PathRecorder::measure_depths() {
  constexpr double kLinks = 0.01;
  std::vector<std::pair<float, double>> cuts;  // Height and length of each stretch that is a cut.
  double left_mm = 0.0;
  for (std::size_t i = 1; i < path_.vertices.size(); ++i) {
    const PathVertex& from = path_.vertices[i - 1];
    const PathVertex& to = path_.vertices[i];
    if (to.move != Move::kCut) continue;
    cuts.emplace_back(to.speed_mm_s, std::hypot(to.x_mm - from.x_mm, to.y_mm - from.y_mm));
    left_mm += kLinks * cuts.back().second;
  }
  std::ranges::sort(cuts, std::ranges::greater{});
  float zero = 0.0F;
  if (!cuts.empty() && cuts.back().first >= 0.0F) {
    for (const auto& [height_mm, length_mm] : cuts) {
      zero = height_mm;
      left_mm -= length_mm;
      if (left_mm < 0.0) break;
    }
  }
  for (PathVertex& vertex : path_.vertices) {
    vertex.speed_mm_s = std::max(zero - vertex.speed_mm_s, 0.0F);
  }
}

void PathRecorder::close_window() {
  last_speed_mm_s_ = static_cast<float>(window_.speed_mm_s(static_cast<double>(last_speed_mm_s_)));
  for (const Sample& sample : samples_) {
    const bool is_travel = sample.move == Move::kTravel;
    const float driven = shown_ == Shown::kSpeed ? last_speed_mm_s_ : sample.value;
    const float speed_mm_s = is_travel ? 0.0F : driven;
    greatest_speed_mm_s_ = std::max(greatest_speed_mm_s_, std::abs(speed_mm_s));
    simplifier_.push({sample.x_mm, sample.y_mm, speed_mm_s, sample.move});
  }
  samples_.clear();
  window_.restart(window_.last_ns(), window_.last());
  simplifier_.set_speed_tolerance(greatest_speed_mm_s_ / kSpeedSteps);
  simplifier_.thin_to(kMaxVertices);
}

}  // namespace sim
