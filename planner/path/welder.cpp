#include "planner/path/welder.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "planner/base/contract.hpp"
#include "planner/geometry/biarc.hpp"

namespace cnc::path {
namespace {

/// Ends are whole nanometres, and single precision sees the points.
constexpr float kPointRoundingMm = 3.0e-6F;
constexpr float kPointRelativeError = 6.0e-7F;  // Of the distance from the start.
/// A tolerance below a tenth of a µm is all rounding.
constexpr float kLeastToleranceMm = 1.0e-4F;
/// Longer lines are meant as lines; beyond so far single precision eats up the tolerance.
constexpr float kLongestLineMm = 20.0F;
constexpr float kFarthestMm = 100.0F;
/// Cosine of the turn that is a corner: 45°.
constexpr float kSharpTurnCosine = 0.7071F;
/// Arcs end before they turn by 130°, where the distance from their start still
/// grows fast enough to tell the points on them apart.
constexpr float kWidestCosine = 0.4226F;  // Of 65°, from tangent to chord.
/// A direction that differs more from that of the piece before begins anew: 17°.
constexpr float kSameWayCosine = 0.955F;
/// No radius below so many tolerances.
constexpr float kLeastRadii = 4.0F;

std::optional<Plane> plane_of(const PathElement& element) {
  AxisArray<bool> moves{};
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    moves[axis] = element.start[axis] != element.end[axis];
    if (moves[axis] && axis >= kLinearAxisCount) return std::nullopt;
  }
  for (const Plane plane : {Plane::kXY, Plane::kZX, Plane::kYZ}) {
    if (!moves[axes_of(plane).normal]) return plane;
  }
  return std::nullopt;
}

Vec2 flat_travel(const Position& from, const Position& to, Plane plane) {
  const PlaneAxes axes = axes_of(plane);
  return {(to[axes.first] - from[axes.first]).mm(), (to[axes.second] - from[axes.second]).mm()};
}

bool can_be_welded(const PathItem& item) {
  const motion::MotionRequest& request = item.request;
  if (item.tolerance.weld_mm < kLeastToleranceMm || request.fixed_feed) return false;
  if (request.element.bulge != 0.0F || request.feed_mm_s <= 0.0F) return false;
  if (request.row.any()) return false;
  const auto plane = plane_of(request.element);
  return plane &&
         flat_travel(request.element.start, request.element.end, *plane).norm() <= kLongestLineMm;
}

FanCircle middle_of(const CircleFan::Through& through) {
  return {.curvature = 0.5F * (through.low.curvature + through.high.curvature),
          .slope = 0.5F * (through.low.slope + through.high.slope)};
}

bool narrow_enough(const Vec2& here, float slope) {
  const Vec2 tangent{1.0F, slope};
  const float along = tangent.dot(here);
  return along > 0.0F && along * along >= kWidestCosine * kWidestCosine * tangent.squaredNorm() *
                                              here.squaredNorm();
}

}  // namespace

bool Welder::alike(const PathItem& item) const {
  const motion::MotionRequest& a = chain_.request;
  const motion::MotionRequest& b = item.request;
  const std::size_t normal = axes_of(plane_).normal;
  return a.feed_mm_s == b.feed_mm_s && a.beam == b.beam && !b.outputs.any() &&
         chain_.tolerance.corner_mm == item.tolerance.corner_mm &&
         chain_.tolerance.weld_mm == item.tolerance.weld_mm &&
         b.element.start[normal] == b.element.end[normal];
}

bool Welder::takes(const PathItem& item) const {
  return can_be_welded(item) && !closing_ && (empty() || alike(item));
}

void Welder::put(const PathItem& item) {
  CNC_ASSERT(has_room());
  const PathElement& element = item.request.element;
  const bool goes_on = known_direction_ && element.start == from_ && alike(item);
  if (empty() && !goes_on) {
    chain_ = item;
    given_out_ = false;
    plane_ = plane_of(element).value_or(Plane::kXY);
    from_ = element.start;
    known_direction_ = false;
  }
  if (empty()) line_ = item.request.line;
  const PlaneAxes axes = axes_of(plane_);
  points_[(oldest_ + count_) % kMostHeld] = {.first = element.end[axes.first],
                                             .second = element.end[axes.second],
                                             .line = item.request.line};
  ++count_;
}

void Welder::clear() {
  count_ = 0;
  oldest_ = 0;
  closing_ = hurries_ = fitting_ = known_direction_ = false;
}

const PathItem* Welder::next() {
  for (int looks = 0; looks < kMostLooks && !empty(); ++looks) {
    if (!fitting_) begin_fit();
    if (looked_at_ < count_) {
      if (look()) continue;
    } else if (!closing_ && !hurries_ && count_ < kMostHeld) {
      return nullptr;
    }
    finish();
    return &chain_;
  }
  if (empty() && closing_) closing_ = known_direction_ = false;
  return nullptr;
}

Vec2 Welder::travel_to(const Point& point) const {
  const PlaneAxes axes = axes_of(plane_);
  return {(point.first - from_[axes.first]).mm(), (point.second - from_[axes.second]).mm()};
}

Position Welder::place_of(const Point& point) const {
  const PlaneAxes axes = axes_of(plane_);
  Position place = from_;
  place[axes.first] = point.first;
  place[axes.second] = point.second;
  return place;
}

Vec2 Welder::seen(const Point& point) const {
  const Vec2 offset = travel_to(point);
  return {offset.dot(ahead_), cross(ahead_, offset)};
}

float Welder::tolerance_at(const Vec2& here) const {
  return chain_.tolerance.weld_mm - kPointRoundingMm - kPointRelativeError * here.norm();
}

void Welder::begin_fit() {
  const Vec2 chord = travel_to(point(0));
  const float length = chord.norm();
  const bool same_way = known_direction_ && chord.dot(ahead_) >= kSameWayCosine * length;
  if (!same_way) {
    known_direction_ = false;
    ahead_ = length > 0.0F ? Vec2{chord / length} : Vec2{1.0F, 0.0F};
  }
  fan_.open(1.0F / (kLeastRadii * chain_.tolerance.weld_mm));
  looked_at_ = points_fitted_ = 0;
  last_ = {0.0F, 0.0F};
  chord_passed_ = 0.0F;
  farthest_ = {};
  smooth_ = {};
  fitting_ = true;
}

/// The way from the start grows, so that nothing is driven past and no point
/// lies beyond the end.
bool Welder::goes_on(const Vec2& here, const Vec2& chord) const {
  if (points_fitted_ == 0) return true;
  const float both = std::sqrt(chord.squaredNorm() * last_chord_.squaredNorm());
  if (chord.dot(last_chord_) < kSharpTurnCosine * both) return false;
  return chord.dot(last_) >= 0.0F && here.norm() <= kFarthestMm;
}

/// The circles must pass the point, and both ends of the chord to it. An end that a longer
/// chord has been passed at is passed at this one, too: so a little more is asked for, and
/// lines of nearly the same length do not each ask for the same again.
void Welder::pass(const Vec2& here, float chord_mm) {
  constexpr float kAlike = 1.05F;
  const float within = tolerance_at(here);
  if (chord_mm > chord_passed_) fan_.pass_chord(last_, chord_mm, within);
  fan_.pass(here, within);
  chord_passed_ = kAlike * chord_mm;
  fan_.pass_chord(here, chord_passed_, within);
}

/// Takes the next point into the fit; false when there it ends.
bool Welder::look() {
  const Vec2 here = seen(point(looked_at_));
  const Vec2 chord = here - last_;
  if (!goes_on(here, chord)) return false;
  pass(here, chord.norm());
  if (fan_.empty()) return false;
  ++looked_at_;
  ++points_fitted_;
  last_ = here;
  last_chord_ = chord;
  note_reach(here);
  forget_points();
  return true;
}

/// A line if one will do, else the middle of what the tolerance leaves.
void Welder::note_reach(const Vec2& here) {
  const auto through = fan_.through(here);
  if (!through) return;
  Reach reach{.points = points_fitted_,
              .index = looked_at_,
              .end = point(looked_at_ - 1),
              .seen = here,
              .circle = middle_of(*through)};
  const bool straight = through->low.curvature * through->high.curvature <= 0.0F;
  if (straight && here.x() > 0.0F) reach.circle = {.curvature = 0.0F, .slope = here.y() / here.x()};
  if (narrow_enough(here, reach.circle.slope)) farthest_ = reach;
  const bool same_way = through->low.slope <= 0.0F && through->high.slope >= 0.0F;
  if (!known_direction_ || !same_way || !narrow_enough(here, 0.0F)) return;
  reach.circle = {.curvature = 2.0F * here.y() / here.squaredNorm(), .slope = 0.0F};
  smooth_ = reach;
}

/// Of the points only those after the ends that may be chosen are still needed.
void Welder::forget_points() {
  if (2 * smooth_.points < farthest_.points) smooth_ = {};
  const std::size_t needed =
      smooth_.points > 0 ? std::min(smooth_.index, farthest_.index) : farthest_.index;
  forget_first(needed);
}

void Welder::forget_first(std::size_t count) {
  oldest_ = (oldest_ + count) % kMostHeld;
  count_ -= count;
  looked_at_ -= std::min(looked_at_, count);
  farthest_.index -= std::min(farthest_.index, count);
  smooth_.index -= std::min(smooth_.index, count);
}

void Welder::finish() {
  const bool smooth = smooth_.points > 0 && 2 * smooth_.points >= farthest_.points;
  Reach reach = smooth ? smooth_ : farthest_;
  if (reach.points == 0) {
    // Not even one point is within reach of a circle: the line to it, as it is.
    reach = {.points = 1, .index = 1, .end = point(0), .seen = seen(point(0))};
    reach.circle.slope = reach.seen.y() / std::max(reach.seen.x(), 1.0e-9F);
  }
  motion::MotionRequest& piece = chain_.request;
  chain_.continues = smooth;
  if (given_out_) piece.outputs = {};
  given_out_ = true;
  piece.line = line_;
  piece.element = {.start = from_, .end = place_of(reach.end), .plane = plane_};
  if (reach.circle.curvature != 0.0F) {
    piece.element.bulge = bulge_between(Vec2{1.0F, reach.circle.slope}, reach.seen);
  }
  hurries_ = false;
  go_to(reach);
  if (!empty()) line_ = point(0).line;
}

/// The end's direction is the start's, mirrored at the chord.
void Welder::go_to(const Reach& reach) {
  const Vec2 chord = reach.seen.normalized();
  const Vec2 tangent = Vec2{1.0F, reach.circle.slope}.normalized();
  const Vec2 end =
      reach.circle.curvature != 0.0F ? Vec2{2.0F * tangent.dot(chord) * chord - tangent} : chord;
  const Vec2 ahead = end.x() * ahead_ + end.y() * left_normal(ahead_);
  ahead_ = ahead.normalized();
  from_ = place_of(reach.end);
  known_direction_ = true;
  fitting_ = false;
  forget_first(reach.index);
}

}  // namespace cnc::path
