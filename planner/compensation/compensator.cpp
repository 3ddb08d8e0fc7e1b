#include "planner/compensation/compensator.hpp"

#include <algorithm>
#include <cmath>

#include "planner/base/contract.hpp"
#include "planner/motion/planned_slice.hpp"

namespace cnc::compensation {

void Compensator::begin(const Position& here, Plane plane, float offset_mm) {
  clear();
  plane_ = plane;
  programmed_ = driven_ = here;
  chain_.begin(place_of(here), offset_mm);
  active_ = true;
}

void Compensator::clear() {
  chain_.begin({}, 0.0F);
  outputs_ = {};
  active_ = beside_ = ended_ = false;
  free_ = given_ = kind_ = 0;
}

Place Compensator::place_of(const Position& position) const {
  const PlaneAxes axes = axes_of(plane_);
  return {position[axes.first], position[axes.second]};
}

std::optional<Fault> Compensator::refusal_of(const path::PathItem& item) const {
  const PathElement& element = item.request.element;
  const PlaneAxes axes = axes_of(plane_);
  Fault fault = chain_.fault(Reason::kOtherAxis, chain_.size(), chain_.size());
  fault.line = item.request.line.number;
  if (element.bulge != 0.0F && element.plane != plane_) return fault;
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    if (axis == axes.first || axis == axes.second) continue;
    if (element.end[axis] != element.start[axis]) return fault;
  }
  if (chain_.size() > 0) return std::nullopt;
  fault.reason = Reason::kEntryNotALine;
  if (element.bulge != 0.0F) return fault;
  fault.reason = Reason::kEntryTooShort;
  const float x = (element.end[axes.first] - element.start[axes.first]).mm();
  const float y = (element.end[axes.second] - element.start[axes.second]).mm();
  if (!(std::sqrt(x * x + y * y) > std::abs(chain_.distance()))) return fault;
  return std::nullopt;
}

std::optional<Fault> Compensator::put(const path::PathItem& item) {
  CNC_ASSERT(active_ && !ended_ && has_room());
  if (auto fault = refusal_of(item)) return fault;
  programmed_ = item.request.element.end;
  const Place end = place_of(programmed_);
  const Place& start = chain_.end();
  const float x = (end[0] - start[0]).mm();
  const float y = (end[1] - start[1]).mm();
  // Too short for a direction: the next element begins where this one does.
  if (std::max(std::abs(x), std::abs(y)) <= kTouch) return std::nullopt;
  const motion::MotionRequest& request = item.request;
  if (chain_.size() == OffsetChain::kCapacity) {
    --given_;
    --free_;
  }
  if (const auto fault = chain_.append({.end = end,
                                        .bulge = request.element.bulge,
                                        .feed_mm_s = request.feed_mm_s,
                                        .beam = request.beam,
                                        .tolerance = item.tolerance,
                                        .line = request.line,
                                        .outputs = request.outputs,
                                        .continues = item.continues})) {
    return fault;
  }
  if (chain_.size() - given_ <= kLookAhead) return std::nullopt;
  if (const auto fault = chain_.check(given_, false)) return fault;
  chain_.settle(++free_);
  return std::nullopt;
}

std::optional<Fault> Compensator::end() {
  CNC_ASSERT(active_ && has_room());
  if (ended_) return std::nullopt;
  for (std::size_t i = given_; i < chain_.size(); ++i) {
    if (const auto fault = chain_.check(i, true)) return fault;
  }
  free_ = chain_.size();
  ended_ = true;
  beside_ = free_ > 0;
  active_ = beside_;
  return std::nullopt;
}

/// The next raw curve that is driven, as seen from the start of its element.
std::optional<Curve> Compensator::next_stretch() {
  while (given_ < free_) {
    if (kind_ == kKinds) {
      kind_ = 0;
      ++given_;
      continue;
    }
    if (kind_ == 0) motion::merge(outputs_, chain_.at(given_).outputs);
    const auto kind = static_cast<Kind>(kind_);
    const bool live = chain_.at(given_).stretches[kind_++].live;
    if (live) return chain_.driven(given_, kind);
  }
  active_ = active_ && !ended_;
  return std::nullopt;
}

bool Compensator::take(path::PathItem& item) {
  while (const auto way = next_stretch()) {
    if (give(*way, item)) return true;
  }
  return false;
}

/// False for a way that is none.
bool Compensator::give(const Curve& way, path::PathItem& item) {
  const HeldElement& held = chain_.at(given_);
  const Place& origin = chain_.start_of(given_);
  const PlaneAxes axes = axes_of(plane_);
  const bool after_join =
      given_ > 0 && chain_.at(given_ - 1).stretches[static_cast<std::size_t>(Kind::kJoin)].live;
  const Position start = driven_;
  driven_[axes.first] = origin[0] + from_mm(way.end.x());
  driven_[axes.second] = origin[1] + from_mm(way.end.y());
  if (start == driven_) return false;
  const Vec2 begin{(start[axes.first] - origin[0]).mm(), (start[axes.second] - origin[1]).mm()};
  const float bulge = way.curvature == 0.0F ? 0.0F : way.bulge_between(begin, way.end);
  motion::BeamCommand beam = held.beam;
  if (!chain_.is_entry(given_)) beam.beside = side();
  item = {.request = {.element = {.start = start,
                                  .end = driven_,
                                  .plane = plane_,
                                  .bulge = std::clamp(bulge, -1.0F, 1.0F)},
                      .feed_mm_s = held.feed_mm_s,
                      .beam = beam,
                      .outputs = outputs_,
                      .line = held.line},
          .tolerance = held.tolerance,
          .continues = held.continues || kind_ == kKinds || after_join};
  outputs_ = {};
  return true;
}

motion::Beside Compensator::side() const {
  return chain_.distance() < 0.0F ? motion::Beside::kLeft : motion::Beside::kRight;
}

std::optional<Fault> Compensator::leave(const Position& to) {
  beside_ = false;
  return chain_.check_exit(place_of(to));
}

Fault Compensator::refuse_to_leave() const {
  return chain_.fault(Reason::kExitNotALine, chain_.size(), chain_.size());
}

}  // namespace cnc::compensation
