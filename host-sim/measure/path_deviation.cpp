#include "host-sim/measure/path_deviation.hpp"

namespace sim {
namespace {

Point steps_of(const cnc::AxisArray<double>& steps_per_mm) {
  Point step{};
  for (std::size_t i = 0; i < step.size(); ++i) step[i] = 1.0 / steps_per_mm[i];
  return step;
}

}  // namespace

PathDeviation::PathDeviation(const ProgrammedPath& path,
                             const cnc::AxisArray<double>& steps_per_mm,
                             double floor)
    : path_{&path}, step_{steps_of(steps_per_mm)}, follower_{path, step_}, last_{path.start} {
  excess_.value = floor;
}

void PathDeviation::on_row(const TraceRow& row) {
  Point place{};
  for (std::size_t i = 0; i < place.size(); ++i) place[i] = row.position[i] * step_[i];
  stand(row.time_ns, place);
}

void PathDeviation::stand(std::uint64_t time_ns, const Point& place) {
  last_ = place;
  match_ = follower_.advance(last_);
  const PathFollower::Match& match = match_;
  if (match.nearest.distance > distance_.value) {
    distance_ = {match.nearest.distance, time_ns, last_, line_of(match.piece)};
  }
  const double excess = follower_.axis_excess(last_, excess_.value);
  if (excess > excess_.value) excess_ = {excess, time_ns, last_, line_of(match.piece)};
}

int PathDeviation::line_of(std::size_t piece) const {
  return path_->pieces.empty() ? 0 : path_->pieces[piece].line;
}

const PathPiece* PathDeviation::present_piece() const {
  if (path_->pieces.empty()) return nullptr;
  return &path_->pieces[follower_.piece()];
}

double PathDeviation::distance_to_end() const { return distance(last_, path_->end); }

bool PathDeviation::reached_last_piece() const {
  // Greatest distance by which the place of the PathFollower may trail the machine, in steps. With
  // tiny pieces, this distance spans many pieces.
  constexpr double kTrail = 4.0;
  double left = 0.0;
  for (std::size_t i = follower_.piece() + 1; i < path_->pieces.size(); ++i) {
    left += path_->pieces[i].curve.length();
  }
  return left <= kTrail * norm(step_);
}

}  // namespace sim
