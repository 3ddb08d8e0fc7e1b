#include "host-sim/measure/energy_meter.hpp"

#include <algorithm>
#include <cmath>

namespace sim {
namespace {

constexpr double kSecondsPerNs = 1.0e-9;

/// Least speed of an axis, as a share of the speed along the path. Edges of a slower axis are
/// ignored.
constexpr double kMinShare = 0.5;

}  // namespace

EnergyMeter::EnergyMeter(const ProgrammedPath& path,
                         const PathDeviation& deviation,
                         const cnc::AxisArray<double>& steps_per_mm,
                         Options options)
    : path_{&path}, deviation_{&deviation}, options_{std::move(options)} {
  for (std::size_t i = 0; i < step_.size(); ++i) step_[i] = 1.0 / steps_per_mm[i];
  place_before_.push_back(0.0);
  programmed_before_.push_back(0.0);
  for (const PathPiece& piece : path.pieces) {
    const bool lit = piece.travel == Travel::kFeed && piece.spindle != SpindleState::kOff &&
                     piece.spindle_speed > 0.0 && piece.feed > 0.0;
    const double least = std::min(options_.min_speed, options_.max_speed);
    const double power =
        std::clamp(piece.spindle_speed, least, options_.max_speed) / options_.max_speed;
    density_.push_back(lit ? power / piece.path_feed() : 0.0);
    place_before_.push_back(place_before_.back() + piece.curve.length());
    programmed_before_.push_back(programmed_before_.back() +
                                 density_.back() * piece.curve.length());
  }
}

void EnergyMeter::on_row(const TraceRow& row) {
  pass_to(row.time_ns);
  if (!path_->pieces.empty() && row.position != position_) look(row.position);
  position_ = row.position;
  duty_ = row.duty;
  if (duty_ <= 0.0F) light_dark_ = light_;
}

void EnergyMeter::pass_to(std::uint64_t time_ns) {
  const double seconds = static_cast<double>(time_ns - time_ns_) * kSecondsPerNs;
  time_ns_ = time_ns;
  if (duty_ <= 0.0F) return;
  const double light = options_.light ? options_.light(duty_) : static_cast<double>(duty_);
  light_ += light * seconds;
}

/// Returns the fraction of the piece for this row. If several motors step at the same time, the
/// step that was due first counts, because the other steps came early.
std::optional<double> EnergyMeter::fraction_at(const PathFollower::Match& match,
                                               const cnc::AxisArray<std::int32_t>& position) const {
  std::optional<double> earliest;
  for (std::size_t axis = 0; axis < position.size(); ++axis) {
    if (position[axis] == position_[axis]) continue;
    const Edge edge{
        .axis = axis,
        .place = 0.5 * (static_cast<double>(position[axis]) + position_[axis]) * step_[axis],
        .direction = position[axis] > position_[axis] ? 1.0 : -1.0};
    const double found = crossing(path_->pieces[match.piece].curve, match.nearest.fraction, edge);
    if (found >= 0.0 && (!earliest || found < *earliest)) earliest = found;
  }
  return earliest;
}

void EnergyMeter::look(const cnc::AxisArray<std::int32_t>& position) {
  const PathFollower::Match& match = deviation_->present_match();
  const std::size_t piece = match.piece;
  const auto fraction = fraction_at(match, position);
  if (!fraction) return;
  const bool has_run = run_end_ > run_first_;
  if (has_run && piece >= run_end_) end_run();
  // Near a corner, the nearest piece may again be the previous piece.
  if (!lit(piece) || piece < run_first_) return;
  if (piece >= run_end_) begin_run(piece);
  if (samples_.empty()) return;
  const double way = *fraction * path_->pieces[piece].curve.length();
  Sample sample = at_start_of(piece);
  sample.place += way;
  sample.programmed += way * density_[piece];
  add(sample);
}

/// Returns the fraction at which the edge is due; negative if it cannot be determined. At a sharp
/// corner, the direction shows whether `curve` is the piece that is being driven.
double EnergyMeter::crossing(const Curve& curve, double near, const Edge& edge) {
  constexpr int kIterations = 4;
  double fraction = near;
  for (int i = 0; i < kIterations; ++i) {
    const double share = curve.tangent_at(fraction)[edge.axis];
    if (share * edge.direction < kMinShare) return -1.0;
    fraction += (edge.place - curve.point_at(fraction)[edge.axis]) / (share * curve.length());
    if (fraction < 0.0 || fraction > 1.0) return -1.0;
  }
  return fraction;
}

EnergyMeter::Sample EnergyMeter::at_start_of(std::size_t piece) const {
  return {place_before_[piece], light_, programmed_before_[piece]};
}

void EnergyMeter::begin_run(std::size_t piece) {
  std::size_t first = piece;
  while (first > run_end_ && lit(first - 1)) --first;
  run_first_ = first;
  run_end_ = piece + 1;
  while (run_end_ < density_.size() && lit(run_end_)) ++run_end_;
  Sample start = at_start_of(run_first_);
  start.light = duty_ > 0.0F ? light_dark_ : light_;
  samples_.assign(1, start);
  sum_light_ -= start.light;
  sum_programmed_ -= start.programmed;
}

/// Ends a run. The beam is now off, or it stays on at a single point.
void EnergyMeter::end_run() {
  const Sample end = at_start_of(run_end_);
  add(end);
  sum_light_ += end.light;
  sum_programmed_ += end.programmed;
  samples_.clear();
  run_first_ = run_end_;
}

void EnergyMeter::add(const Sample& sample) {
  if (samples_.empty() || sample.place <= samples_.back().place) return;
  samples_.push_back(sample);
  const double from = sample.place - kWindow;
  while (samples_.size() > 2 && samples_[1].place <= from) samples_.pop_front();
  const Sample& before = samples_[0];
  const Sample& after = samples_[1];
  if (before.place > from) return;
  const double share = (from - before.place) / (after.place - before.place);
  const double light = before.light + share * (after.light - before.light);
  const double programmed = before.programmed + share * (after.programmed - before.programmed);
  if (options_.on_window) options_.on_window((sample.light - light) / (sample.place - from));
  const double ratio = (sample.light - light) / (sample.programmed - programmed);
  const bool first = figures_.windows++ == 0;
  if (first || ratio < figures_.least) {
    figures_.least = ratio;
    figures_.min_at_mm = sample.place;
  }
  if (first || ratio > figures_.greatest) {
    figures_.greatest = ratio;
    figures_.greatest_at_mm = sample.place;
  }
}

void EnergyMeter::on_end(std::uint64_t time_ns) {
  pass_to(time_ns);
  if (run_end_ > run_first_) end_run();
}

EnergyFigures EnergyMeter::figures() const {
  EnergyFigures figures = figures_;
  figures.mean = sum_programmed_ > 0.0 ? sum_light_ / sum_programmed_ : 0.0;
  return figures;
}

}  // namespace sim
