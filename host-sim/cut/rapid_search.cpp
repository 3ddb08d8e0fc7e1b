#include "host-sim/cut/rapid_search.hpp"

#include <algorithm>

namespace sim::cut {
namespace {

/// Factors by which estimates multiply the remaining distance to the goal. With the first factor,
/// paths are at most some per cent too long. The second factor makes a long search proceed straight
/// towards the goal.
constexpr double kCareful = 1.02;
constexpr double kHasty = 1.6;
constexpr std::uint64_t kCarefulTrials = 3'000;

}  // namespace

RapidSearch::RapidSearch(const FreeLegs& legs,
                         const RapidEnd& from,
                         const RapidEnd& to,
                         const Place& lowest)
    : legs_{&legs}, from_{&from}, to_{&to}, lowest_{lowest}, nodes_(2) {
  nodes_[kFrom].corner.place = from.place;
  nodes_[kTo].corner.place = to.place;
  nodes_[kFrom].state = State::kFree;
  nodes_[kTo].state = State::kFree;
}

RapidSearch::Outcome RapidSearch::find(std::uint64_t max_trials) {
  if (!nodes_[kFrom].is_reached) reach(kFrom, kFrom);
  while (!trials_.empty()) {
    if (tried_ >= max_trials) return Outcome::kGaveUp;
    const Trial trial = trials_.top();
    trials_.pop();
    try_leg(trial);
    if (nodes_[kTo].is_reached) return Outcome::kFound;
  }
  return Outcome::kNoWay;
}

void RapidSearch::push(std::size_t from, std::size_t to) {
  const Place& end = nodes_[to].corner.place;
  const double leg = drawing::distance(nodes_[from].corner.place, end);
  const double factor = tried_ < kCarefulTrials ? kCareful : kHasty;
  const double rest = factor * drawing::distance(end, nodes_[kTo].corner.place);
  trials_.push({nodes_[from].way_mm + leg + rest, pushed_++, from, to});
}

void RapidSearch::try_leg(const Trial& trial) {
  if (nodes_[trial.to].is_reached) return;
  ++tried_;
  if (!is_free(nodes_[trial.to])) return add_corners_of(nodes_[trial.to].covered_by, trial.from);
  if (const auto area = blocker(trial.from, trial.to)) return add_corners_of(*area, trial.from);
  reach(trial.to, trial.from);
}

void RapidSearch::reach(std::size_t node, std::size_t parent) {
  const double leg = drawing::distance(nodes_[node].corner.place, nodes_[parent].corner.place);
  nodes_[node].is_reached = true;
  nodes_[node].parent = parent;
  nodes_[node].way_mm = nodes_[parent].way_mm + leg;
  if (node != kTo) push(node, kTo);
}

void RapidSearch::add_corners_of(std::uint32_t area, std::size_t seen_from) {
  if (!shown_.emplace(seen_from, area).second) return;
  const AreaCorner from = nodes_[seen_from].corner;
  const bool turns_anywhere = !nodes_[seen_from].is_corner;
  for (const std::size_t index : nodes_of(area)) {
    const Node& node = nodes_[index];
    if (node.is_reached || index == seen_from) continue;
    if (node.corner.place.x() < lowest_.x() || node.corner.place.y() < lowest_.y()) {
      was_bounded_ = true;
      continue;
    }
    if (!node.corner.is_touched_from(from.place)) continue;
    if (!turns_anywhere && !from.is_touched_from(node.corner.place)) continue;
    push(seen_from, index);
  }
}

const std::vector<std::size_t>& RapidSearch::nodes_of(std::uint32_t area) {
  const auto [found, is_new] = corners_.try_emplace(area);
  if (!is_new) return found->second;
  for (const AreaCorner& corner :
       corners_around(legs_->areas().area(area), legs_->clearance_mm())) {
    found->second.push_back(nodes_.size());
    nodes_.push_back({.corner = corner, .is_corner = true});
  }
  return found->second;
}

bool RapidSearch::is_free(Node& node) {
  if (node.state == State::kUnknown) {
    const auto area = legs_->area_at(node.corner.place);
    node.state = area ? State::kCovered : State::kFree;
    node.covered_by = area.value_or(0);
  }
  return node.state == State::kFree;
}

std::optional<std::uint32_t> RapidSearch::blocker(std::size_t from, std::size_t to) const {
  return legs_->blocker(nodes_[from].corner.place,
                        nodes_[to].corner.place,
                        from == kFrom ? from_ : nullptr,
                        to == kTo ? to_ : nullptr);
}

std::vector<Place> RapidSearch::way() const {
  std::vector<Place> way;
  for (std::size_t node = kTo; node != kFrom; node = nodes_[node].parent) {
    way.push_back(nodes_[node].corner.place);
  }
  way.push_back(nodes_[kFrom].corner.place);
  std::ranges::reverse(way);
  return way;
}

}  // namespace sim::cut
