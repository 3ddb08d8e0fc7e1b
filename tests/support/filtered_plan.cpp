#include "tests/support/filtered_plan.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sim {

FilteredPlan::FilteredPlan(std::vector<PlanPiece> pieces, double window) : window_{window} {
  constexpr double kForever = std::numeric_limits<double>::infinity();
  pieces_.push_back({.place = pieces.front().place});
  starts_.push_back(-kForever);
  double time = 0.0;
  for (const PlanPiece& piece : pieces) {
    if (piece.duration <= 0.0) continue;
    pieces_.push_back(piece);
    starts_.push_back(time);
    time += piece.duration;
  }
  const PlanPiece& last = pieces_.back();
  pieces_.push_back({.duration = kForever, .place = last.place_after(last.duration)});
  starts_.push_back(time);
}

std::size_t FilteredPlan::piece_at(double time, std::size_t guess) const {
  while (guess > 0 && time < starts_[guess]) --guess;
  while (guess + 1 < starts_.size() && starts_[guess + 1] <= time) ++guess;
  return guess;
}

FilteredPlan::Moment FilteredPlan::moment(double time, std::size_t piece) const {
  if (piece == 0) return {.place = pieces_[0].place};
  const double within = time - starts_[piece];
  const PlanPiece& it = pieces_[piece];
  return {it.place_after(within), it.speed_after(within), it.acceleration};
}

double FilteredPlan::mean_place(double time, std::size_t first, std::size_t last) const {
  // Positions are counted from the oldest one in the window, because digits would be lost far from
  // the start.
  const double from = time - window_;
  const double base = moment(from, first).place;
  double integral = 0.0;
  for (std::size_t i = std::max<std::size_t>(first, 1); i <= last; ++i) {
    const double begin = std::max(from, starts_[i]) - starts_[i];
    const double end = (i == last ? time : starts_[i + 1]) - starts_[i];
    integral += pieces_[i].place_integral(end, base);
    if (begin > 0.0) integral -= pieces_[i].place_integral(begin, base);
  }
  return base + integral / window_;
}

PathState FilteredPlan::at(double time) const {
  oldest_ = piece_at(time - window_, oldest_);
  newest_ = piece_at(time, std::max(newest_, oldest_));
  const Moment old = moment(time - window_, oldest_);
  const Moment now = moment(time, newest_);
  return {mean_place(time, oldest_, newest_),
          (now.place - old.place) / window_,
          (now.speed - old.speed) / window_,
          (now.acceleration - old.acceleration) / window_};
}

std::vector<double> FilteredPlan::breakpoints() const {
  std::vector<double> times;
  for (std::size_t i = 1; i < starts_.size(); ++i) {
    times.push_back(starts_[i]);
    times.push_back(starts_[i] + window_);
  }
  std::ranges::sort(times);
  return times;
}

FilteredPlan::Gap FilteredPlan::greatest_gap() const {
  Gap gap;
  for (std::size_t i = 1; i < pieces_.size(); ++i) {
    const PlanPiece& before = pieces_[i - 1];
    const double duration = i == 1 ? 0.0 : before.duration;
    gap.place = std::max(gap.place, std::abs(before.place_after(duration) - pieces_[i].place));
    gap.speed = std::max(gap.speed, std::abs(before.speed_after(duration) - pieces_[i].speed));
  }
  return gap;
}

}  // namespace sim
