#include "planner/path/welder.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "planner/base/contract.hpp"
#include "planner/geometry/biarc.hpp"

namespace cnc::path {
namespace {

/// Allowance for the rounding of ends to nanometres and for the rounding of single precision, mm.
constexpr float kPointRoundingMm = 3.0e-6F;
// Additional allowance for single precision as a share of the distance from the start of the fit.
constexpr float kPointRelativeError = 6.0e-7F;
/// Least tolerance of a weld, mm. Below a tenth of a micrometre, there is only rounding.
constexpr float kMinToleranceMm = 1.0e-4F;
/// Greatest length of a line that is welded, mm: a longer line is meant as a line.
constexpr float kLongestLineMm = 20.0F;
/// Greatest distance of a point from the start of a fit, mm: beyond it, errors of single precision
/// use up the tolerance.
constexpr float kFarthestMm = 100.0F;
/// Cosine of 45°. A joint that turns by more is a corner.
constexpr float kSharpTurnCosine = 0.7071F;
/// Arcs end before they turn by 130°. Up to there, the distance from their start grows fast enough
/// to distinguish the points on them.
constexpr float kWidestCosine = 0.4226F;  // Cosine of 65°, the angle between tangent and chord.
/// Cosine of 17°. If the first line of a fit differs by more from the direction at the end of the
/// piece before, the fit begins without a known direction.
constexpr float kSameWayCosine = 0.955F;
/// Least radius of an arc as a multiple of the tolerance.
constexpr float kMinRadii = 4.0F;

Vec3 way_between(const Position& from, const Position& to) {
  return {(to[0] - from[0]).mm(), (to[1] - from[1]).mm(), (to[2] - from[2]).mm()};
}

AxisVector along_axes(const Vec3& vector) { return {vector.x(), vector.y(), vector.z()}; }

bool moves_linear_axes_only(const PathElement& element) {
  for (std::size_t axis = kLinearAxisCount; axis < kAxisCount; ++axis) {
    if (element.start[axis] != element.end[axis]) return false;
  }
  return true;
}

bool can_be_welded(const PathItem& item) {
  const motion::MotionRequest& request = item.request;
  if (item.tolerance.weld_mm < kMinToleranceMm || request.fixed_feed) return false;
  if (request.element.bulge != 0.0F || request.feed_mm_s <= 0.0F) return false;
  if (request.row.any() || !moves_linear_axes_only(request.element)) return false;
  return way_between(request.element.start, request.element.end).norm() <= kLongestLineMm;
}

/// Returns the first coordinate plane that contains a vector, or nothing if none does.
std::optional<Plane> coordinate_plane_of(const Vec3& way) {
  for (const Plane plane : {Plane::kXY, Plane::kZX, Plane::kYZ}) {
    if (way[static_cast<int>(axes_of(plane).normal)] == 0.0F) return plane;
  }
  return std::nullopt;
}

/// Returns a frame in a coordinate plane, along a direction in that plane.
FitFrame frame_in(Plane plane, const Vec3& ahead) {
  const auto first = static_cast<int>(axes_of(plane).first);
  const auto second = static_cast<int>(axes_of(plane).second);
  FitFrame frame{.ahead = ahead, .left = {0.0F, 0.0F, 0.0F}, .up = {0.0F, 0.0F, 0.0F}};
  frame.left[first] = -ahead[second];
  frame.left[second] = ahead[first];
  frame.up[static_cast<int>(axes_of(plane).normal)] = 1.0F;
  return frame;
}

bool narrow_enough(const Vec3& here, const FitCircle& circle) {
  const Vec3 tangent = circle.tangent();
  const float along = tangent.dot(here);
  return along > 0.0F && along * along >= kWidestCosine * kWidestCosine * tangent.squaredNorm() *
                                              here.squaredNorm();
}

}  // namespace

bool Welder::alike(const PathItem& item) const {
  const motion::MotionRequest& a = chain_.request;
  const motion::MotionRequest& b = item.request;
  return a.feed_mm_s == b.feed_mm_s && a.beam == b.beam && !b.outputs.any() &&
         chain_.tolerance.corner_mm == item.tolerance.corner_mm &&
         chain_.tolerance.weld_mm == item.tolerance.weld_mm;
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
    plane_.reset();
    from_ = element.start;
    known_direction_ = false;
  }
  if (empty()) line_ = item.request.line;
  points_[(oldest_ + count_) % kMaxHeld] = {
      .place = {element.end[0], element.end[1], element.end[2]},
      .aside_mm = item.aside_mm,
      .line = item.request.line};
  ++count_;
}

void Welder::clear() {
  count_ = 0;
  oldest_ = 0;
  closing_ = hurries_ = fitting_ = known_direction_ = false;
}

const PathItem* Welder::next() {
  for (int looks = 0; looks < kMaxLooks && !empty(); ++looks) {
    if (!fitting_) begin_fit();
    if (looked_at_ < count_) {
      if (look()) continue;
    } else if (!closing_ && !hurries_ && count_ < kMaxHeld) {
      return nullptr;
    }
    finish();
    return &chain_;
  }
  if (empty() && closing_) closing_ = known_direction_ = false;
  return nullptr;
}

Vec3 Welder::way_to(const Point& point) const { return way_between(from_, place_of(point)); }

/// Returns the position of a point. A point stores only X Y Z, because the other axes do not move.
Position Welder::place_of(const Point& point) const {
  Position place = from_;
  std::copy(point.place.begin(), point.place.end(), place.begin());
  return place;
}

/// Returns the tolerance of the fit for the line that ends at a point, mm. It is the tolerance of
/// the weld minus rounding and the distance of omitted positions.
/// @param here the point in the frame of the fit
float Welder::tolerance_of(const Point& point, const Vec3& here) const {
  constexpr float kMin = 1.0e-6F;
  const float tolerance =
      chain_.tolerance.weld_mm - kPointRoundingMm - kPointRelativeError * here.norm();
  return std::max(kMin, tolerance - point.aside_mm);
}

void Welder::begin_fit() {
  const Vec3 way = way_to(point(0));
  const float length = way.norm();
  const bool same_way =
      known_direction_ && (is_short(length) || way.dot(ahead_) >= kSameWayCosine * length);
  if (!same_way) {
    known_direction_ = false;
    towards_ = {0.0F, 0.0F, 0.0F};
    ahead_ = length > 0.0F ? Vec3{way / length} : Vec3{1.0F, 0.0F, 0.0F};
  }
  choose_plane(way);
  fit_.begin(plane_ ? frame_in(*plane_, ahead_) : frame_in_space(ahead_, towards_),
             1.0F / (kMinRadii * chain_.tolerance.weld_mm));
  looked_at_ = points_fitted_ = 0;
  last_ = last_chord_ = {0.0F, 0.0F, 0.0F};
  reached_mm_ = 0.0F;
  aside_mm_ = point(0).aside_mm;
  farthest_ = {};
  smooth_ = {};
  fitting_ = true;
}

/// Chooses the plane of the fit. The plane of the previous fit is kept if it contains `way` and the
/// direction `ahead_`, too. Otherwise a coordinate plane that contains both is chosen, or none.
void Welder::choose_plane(const Vec3& way) {
  const auto lies_in = [&](Plane plane) {
    const auto normal = static_cast<int>(axes_of(plane).normal);
    return way[normal] == 0.0F && ahead_[normal] == 0.0F;
  };
  if (plane_ && lies_in(*plane_)) return;
  plane_ = coordinate_plane_of(way);
  if (plane_ && !lies_in(*plane_)) plane_.reset();
}

/// Returns whether the fit may include the next point. The distance from the start must grow, so
/// that no point is beyond the end of the arc. A short line may go in any direction as long as the
/// circles pass its end. The reason is that programs with points on a grid, and offset paths,
/// contain small sideward steps that are not part of the curve.
bool Welder::goes_on(const Vec3& here, const Vec3& chord) const {
  if (plane_ && here.z() != 0.0F) return false;
  if (points_fitted_ == 0 || is_short(chord.norm())) return true;
  const float both = std::sqrt(chord.squaredNorm() * last_chord_.squaredNorm());
  if (chord.dot(last_chord_) < kSharpTurnCosine * both) return false;
  return chord.dot(last_) >= 0.0F && here.norm() <= kFarthestMm;
}

/// Adds the next point to the fit. Returns false if the fit ends before this point.
bool Welder::look() {
  const Vec3 here = fit_.frame().seen(way_to(point(looked_at_)));
  const Vec3 chord = here - last_;
  if (!goes_on(here, chord)) return false;
  fit_.pass(here, tolerance_of(point(looked_at_), here));
  if (fit_.empty()) return false;
  ++looked_at_;
  ++points_fitted_;
  last_ = here;
  if (!is_short(chord.norm())) last_chord_ = chord;
  const float way_mm = here.norm();
  if (way_mm >= reached_mm_) note_reach(here);
  reached_mm_ = std::max(reached_mm_, way_mm);
  forget_points();
  return true;
}

void Welder::note_reach(const Vec3& here) {
  const auto ending = fit_.ending_at(here);
  if (!ending) return;
  const Reach reach{.points = points_fitted_,
                    .index = looked_at_,
                    .end = point(looked_at_ - 1),
                    .seen = here,
                    .circle = ending->best};
  if (narrow_enough(here, reach.circle)) farthest_ = reach;
  if (!known_direction_ || !ending->smooth || !narrow_enough(here, *ending->smooth)) return;
  smooth_ = reach;
  smooth_.circle = *ending->smooth;
}

/// Forgets the points that are no longer required. These are the points up to the nearest possible
/// end of the fit.
void Welder::forget_points() {
  if (2 * smooth_.points < farthest_.points) smooth_ = {};
  const std::size_t needed =
      smooth_.points > 0 ? std::min(smooth_.index, farthest_.index) : farthest_.index;
  forget_first(needed);
}

void Welder::forget_first(std::size_t count) {
  oldest_ = (oldest_ + count) % kMaxHeld;
  count_ -= count;
  looked_at_ -= std::min(looked_at_, count);
  farthest_.index -= std::min(farthest_.index, count);
  smooth_.index -= std::min(smooth_.index, count);
}

void Welder::finish() {
  const bool smooth = smooth_.points > 0 && 2 * smooth_.points >= farthest_.points;
  Reach reach = smooth ? smooth_ : farthest_;
  if (reach.points == 0) {
    // No circle reaches a point, so the result is the programmed line to the first point.
    reach = {.points = 1, .index = 1, .end = point(0)};
    reach.seen = fit_.frame().seen(way_to(point(0)));
    const float ahead = std::max(reach.seen.x(), 1.0e-9F);
    reach.circle = {{0.0F, reach.seen.y() / ahead}, {0.0F, reach.seen.z() / ahead}};
  }
  motion::MotionRequest& piece = chain_.request;
  chain_.continues = smooth;
  chain_.aside_mm = aside_mm_;
  if (given_out_) piece.outputs = {};
  given_out_ = true;
  piece.line = line_;
  piece.element = element_to(reach);
  hurries_ = false;
  go_to(reach);
  if (!empty()) line_ = point(0).line;
}

PathElement Welder::element_to(const Reach& reach) const {
  PathElement element{.start = from_, .end = place_of(reach.end)};
  if (plane_) element.plane = *plane_;
  if (reach.circle.straight()) return element;
  const Vec3 tangent = reach.circle.tangent();
  if (plane_) {
    element.bulge = bulge_between(Vec2{1.0F, tangent.y()}, Vec2{reach.seen.x(), reach.seen.y()});
    return element;
  }
  const AxisVector start = along_axes(fit_.frame().way(tangent.normalized()));
  const AxisVector chord = along_axes(fit_.frame().way(reach.seen.normalized()));
  const auto frame = plane_through(start, chord);
  if (!frame) return element;  // The arc turns by less than rounding, so it is a line.
  element.plane = ArcPlane{*frame};
  element.bulge = bulge_between(Vec2{1.0F, 0.0F}, element.plane.seen(element.start, element.end));
  return element;
}

/// Continues from an end point. The direction there is the direction at the start, mirrored at the
/// chord.
void Welder::go_to(const Reach& reach) {
  const Vec3 chord = reach.seen.normalized();
  const Vec3 tangent = reach.circle.tangent().normalized();
  const Vec3 end =
      reach.circle.straight() ? chord : Vec3{2.0F * tangent.dot(chord) * chord - tangent};
  ahead_ = fit_.frame().way(end).normalized();
  towards_ = fit_.frame().way(end - tangent);
  from_ = place_of(reach.end);
  known_direction_ = true;
  fitting_ = false;
  forget_first(reach.index);
}

}  // namespace cnc::path
