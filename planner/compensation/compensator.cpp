#include "planner/compensation/compensator.hpp"

#include <algorithm>
#include <cmath>

#include "planner/base/contract.hpp"
#include "planner/motion/segment/planned_slice.hpp"

namespace cnc::compensation {

bool moves_in(Plane plane, const PathElement& element) {
  const PlaneAxes axes = axes_of(plane);
  return element.bulge != 0.0F || element.start[axes.first] != element.end[axes.first] ||
         element.start[axes.second] != element.end[axes.second];
}

void Compensator::begin(const Position& here, Plane plane, float offset_mm) {
  clear();
  plane_ = plane;
  programmed_ = driven_ = here;
  chain_.begin(here, plane, offset_mm);
  active_ = true;
}

void Compensator::clear() {
  chain_.begin({}, Plane::kXY, 0.0F);
  outputs_ = {};
  active_ = beside_ = ended_ = false;
  free_ = given_ = kind_ = 0;
}

/// Returns the fault for which an element must be refused before it is appended.
/// @param chord_mm length of the element in the plane
std::optional<Fault> Compensator::refusal_of(const path::PathItem& item, float chord_mm) const {
  const PathElement& element = item.request.element;
  Fault fault = chain_.fault(Reason::kOtherAxis, chain_.size(), chain_.size());
  fault.line = item.request.line.number;
  if (element.bulge != 0.0F && element.plane != plane_) return fault;
  const std::size_t before = chain_.path().previous(chain_.size());
  if (chain_.size() > before + kMaxStanding) return fault;
  if (chain_.size() > 0) return std::nullopt;
  fault.reason = Reason::kEntryTooShort;
  if (!(chord_mm > std::abs(chain_.distance()))) return fault;
  return std::nullopt;
}

std::optional<Fault> Compensator::put(const path::PathItem& item) {
  CNC_ASSERT(active_ && !ended_ && has_room());
  const motion::MotionRequest& request = item.request;
  const PlaneAxes axes = axes_of(plane_);
  const Place before = chain_.end();
  HeldElement held{.end = request.element.end,
                   .bulge = request.element.bulge,
                   .feed_mm_s = request.feed_mm_s,
                   .beam = request.beam,
                   .tolerance = item.tolerance,
                   .line = request.line,
                   .outputs = request.outputs,
                   .continues = item.continues};
  const float x = (held.end[axes.first] - before[0]).mm();
  const float y = (held.end[axes.second] - before[1]).mm();
  if (auto fault = refusal_of(item, std::sqrt(x * x + y * y))) return fault;
  programmed_ = request.element.end;
  // An element of at most kTouch has no direction. The next element begins at its start.
  held.stands = std::max(std::abs(x), std::abs(y)) <= kTouch;
  if (held.stands) {
    held.bulge = 0.0F;
    held.end[axes.first] = before[0];
    held.end[axes.second] = before[1];
    if (held.end == chain_.path().position(chain_.size())) return std::nullopt;
  }
  if (chain_.path().full()) {
    --given_;
    --free_;
  }
  chain_.append(held);
  if (chain_.size() - given_ <= kLookAhead) return std::nullopt;
  if (const auto fault = chain_.check(given_, false)) return fault;
  chain_.settle(++free_);
  return std::nullopt;
}

std::optional<Fault> Compensator::end() {
  CNC_ASSERT(active_ && has_room());
  if (ended_) return std::nullopt;
  if (chain_.size() > 0) chain_.finish();
  for (std::size_t i = given_; i < chain_.size(); ++i) {
    if (const auto fault = chain_.check(i, true)) return fault;
  }
  free_ = chain_.size();
  ended_ = true;
  beside_ = free_ > 0;
  active_ = beside_;
  return std::nullopt;
}

bool Compensator::take(path::PathItem& item) {
  while (given_ < free_) {
    if (kind_ == kKinds) {
      kind_ = 0;
      ++given_;
      continue;
    }
    const HeldElement& held = chain_.at(given_);
    if (kind_ == 0) motion::merge(outputs_, held.outputs);
    const auto kind = static_cast<Kind>(kind_++);
    const bool goes =
        held.stands ? kind == Kind::kParallel : held.stretches[static_cast<std::size_t>(kind)].live;
    if (goes && give(held, kind, item)) return true;
  }
  active_ = active_ && !ended_;
  return false;
}

/// Sets `item` to one raw curve of an element, as the next element to be driven. Returns false if
/// the raw curve has no length.
bool Compensator::give(const HeldElement& held, Kind kind, path::PathItem& item) {
  const PlaneAxes axes = axes_of(plane_);
  PathElement way{.start = driven_, .end = driven_, .plane = plane_};
  // Axes outside the plane move along the element, and not along the join at its end.
  if (kind == Kind::kParallel) way.end = held.end;
  way.end[axes.first] = driven_[axes.first];
  way.end[axes.second] = driven_[axes.second];
  if (!held.stands) lead_along(chain_.driven(given_, kind), way);
  if (way.start == way.end) return false;
  driven_ = way.end;
  motion::BeamCommand beam = held.beam;
  if (!chain_.path().is_entry(given_)) beam.beside = side();
  const bool after_join =
      given_ > 0 && chain_.at(given_ - 1).stretches[static_cast<std::size_t>(Kind::kJoin)].live;
  item = {.request = {.element = way,
                      .feed_mm_s = held.feed_mm_s,
                      .beam = beam,
                      .outputs = outputs_,
                      .line = held.line},
          .tolerance = held.tolerance,
          .continues = held.continues || kind == Kind::kJoin || after_join};
  outputs_ = {};
  return true;
}

/// Sets end and bulge of `way` so that it ends at the end of `curve`. The coordinates of `curve`
/// are relative to the start of the programmed element.
void Compensator::lead_along(const Curve& curve, PathElement& way) const {
  const PlaneAxes axes = axes_of(plane_);
  const Place origin = chain_.path().start_of(given_);
  way.end[axes.first] = origin[0] + from_mm(curve.end.x());
  way.end[axes.second] = origin[1] + from_mm(curve.end.y());
  if (curve.curvature == 0.0F || !moves_in(plane_, way)) return;
  const Vec2 begin = HeldPath::from(origin, chain_.path().place_of(way.start));
  way.bulge = std::clamp(curve.bulge_between(begin, curve.end), -1.0F, 1.0F);
}

motion::Beside Compensator::side() const {
  return chain_.distance() < 0.0F ? motion::Beside::kLeft : motion::Beside::kRight;
}

void Compensator::stand_at(const Position& here) {
  const PlaneAxes axes = axes_of(plane_);
  programmed_ = here;
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    if (axis != axes.first && axis != axes.second) driven_[axis] = here[axis];
  }
}

std::optional<Fault> Compensator::leave(const Position& to, bool rapid) {
  beside_ = false;
  if (const auto fault = chain_.leave(driven_, to, rapid)) return fault;
  // The arc around the corner at the end of the path may still have to be driven. It is the join of
  // the last element.
  given_ = chain_.path().previous(chain_.size());
  free_ = given_ + 1;
  kind_ = static_cast<std::size_t>(Kind::kJoin);
  return std::nullopt;
}

Fault Compensator::refuse_to_leave() const {
  return chain_.fault(Reason::kExitNotALine, chain_.size(), chain_.size());
}

}  // namespace cnc::compensation
