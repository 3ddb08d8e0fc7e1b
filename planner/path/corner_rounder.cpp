#include "planner/path/corner_rounder.hpp"

#include <algorithm>

#include "planner/base/contract.hpp"
#include "planner/path/corner_choice.hpp"

namespace cnc::path {
namespace {

/// Least trim of a blend that is divided into halves, mm. Shorter halves would consist only of
/// rounding.
constexpr float kMinDivided = 1.0e-3F;

/// Allowance for the rounding of ends to nanometres, mm.
constexpr float kRoundedEndMm = 1.5e-6F;

/// Share of the element after a corner by which the corner may exceed its allowance, if it then
/// uses up the element before the corner. Without this share, edges of nearly equal length would
/// leave lines between their arcs that are too short to be useful.
constexpr float kMoreThanHalf = 0.03125F;

motion::Joint joint_at(const Corner& corner) {
  return corner.kind == Corner::Kind::kSmooth ? motion::Joint::kSmooth : motion::Joint::kStop;
}

/// Returns whether feed, beam or outputs change at the corner between two elements. They must
/// change exactly there. A row of pixels counts as a change of the beam.
bool differ(const motion::MotionRequest& a, const motion::MotionRequest& b) {
  return a.feed_mm_s != b.feed_mm_s || !(a.beam == b.beam) || a.row.any() || b.row.any() ||
         !(b.outputs == motion::OutputChanges{});
}

/// Sets `place` to an element from which no corner has taken any length yet.
void hold(std::optional<HeldItem>& place, const PathItem& item, motion::Joint joint) {
  HeldItem& held = place.emplace();
  held.item = item;
  held.start = item.request.element.start;
  held.joint = joint;
}

}  // namespace

const PathPiece* CornerRounder::next() {
  if (has_room()) return nullptr;
  const PathPiece* const piece = &ready_[taken_++];
  if (taken_ == ready_count_) taken_ = ready_count_ = 0;
  return piece;
}

motion::SourceLine CornerRounder::line() const {
  if (!has_room()) return ready_[taken_].request.line;
  return first_ ? first_->item.request.line : motion::SourceLine{};
}

void CornerRounder::clear() {
  first_.reset();
  second_.reset();
  last_.reset();
  taken_ = ready_count_ = 0;
  stop_left_over_ = false;
}

void CornerRounder::put(const PathItem& item) {
  CNC_ASSERT(has_room());
  const PathItem* const before = newest();
  next_corner_.kind = Corner::Kind::kStop;
  if (before != nullptr) examine(*before, item, limits_, next_corner_);
  if (!first_) {
    hold(first_, item, joint_at(next_corner_));
    last_.reset();
    return;
  }
  if (second_) {
    const float length = corner_.after.length;
    const float wanted = next_corner_.kind == Corner::Kind::kBlend ? next_corner_.wish_mm : 0.0F;
    settle(std::max(0.5F * length, length - wanted));
  }
  meet(item);
}

/// Returns the item that was added last, or null at the start of the path.
const PathItem* CornerRounder::newest() const {
  if (second_) return &second_->item;
  if (first_) return &first_->item;
  return last_ ? &*last_ : nullptr;
}

/// Handles next_corner_, which is the corner before `item`. @pre only the first element is held
void CornerRounder::meet(const PathItem& item) {
  if (next_corner_.kind == Corner::Kind::kBlend) {
    corner_ = next_corner_;
    hold(second_, item, motion::Joint::kStop);
    return;
  }
  give_rest(*first_, first_->item.request.element.end, -1.0F);
  hold(first_, item, joint_at(next_corner_));
}

void CornerRounder::flush() {
  CNC_ASSERT(has_room());
  if (second_) settle(corner_.after.length);
  if (!first_) return;
  give_rest(*first_, first_->item.request.element.end, -1.0F);
  last_ = first_->item;
  first_.reset();
}

void CornerRounder::expect(const PathItem& item) {
  const std::optional<HeldItem>& newest = second_ ? second_ : first_;
  if (newest && stop_between(newest->item, item)) flush();
}

/// Returns the greatest trim that both sides and the tolerance permit.
/// @param allowance_mm length of the second element that the corner may use
float CornerRounder::granted(float allowance_mm) const {
  const float left = corner_.before.length - first_->used_mm;
  const float side = corner_.after.length;
  const bool all = left <= std::min(side, allowance_mm + kMoreThanHalf * side);
  const float most = all ? left : allowance_mm;
  if (corner_.wish_mm <= most) return corner_.wish_mm;
  return most >= kCrumbMm ? fitting_trim(corner_, most) : 0.0F;
}

/// Returns a trim that uses up each side or leaves more than a crumb of it. A side counts as used
/// up if its rest has no more effect than rounding. The rest changes the direction by the ratio of
/// its length to the chord of the blend. That chord is short if the blend nearly turns back. A
/// shorter trim for the second side can leave a crumb of the first side, so the first side is
/// checked twice.
float CornerRounder::without_crumbs(float trim_mm) const {
  const AxisVector both =
      sum_of(corner_.before.direction(0.0F), 1.0F, corner_.after.direction(0.0F));
  const float all_share = 0.5F * motion::kTangentTurn * std::min(1.0F, norm(both));
  const float left = corner_.before.length - first_->used_mm;
  float trim = trim_mm;
  for (const float side : {left, corner_.after.length, left}) {
    const float rest = side - trim;
    const bool all = rest <= kRoundedEndMm + all_share * trim;
    if (!all && rest < kCrumbMm) trim = fitting_trim(corner_, 0.5F * side);
  }
  return trim;
}

bool CornerRounder::is_stop_sooner_than(float trim_mm) const {
  const RoundedCorner rounded{
      .trim_mm = trim_mm,
      .shorter_mm = std::min(corner_.before.length - first_->used_mm, corner_.after.length),
      .feed_mm_s = std::max(first_->item.request.feed_mm_s, second_->item.request.feed_mm_s)};
  return is_stop_sooner(corner_, rounded, limits_);
}

/// Settles the corner between the two held elements. The second element becomes the first.
/// @param allowance_mm length of the second element that the corner may use
void CornerRounder::settle(float allowance_mm) {
  const float trim = without_crumbs(granted(allowance_mm));
  const bool in_halves = differ(first_->item.request, second_->item.request);
  if (trim >= (in_halves ? kMinDivided : kCrumbMm) && !is_stop_sooner_than(trim)) {
    blend(trim, in_halves);
  } else {
    give_rest(*first_, first_->item.request.element.end, -1.0F);
  }
  first_ = second_;
  second_.reset();
}

void CornerRounder::blend(float trim_mm, bool in_halves) {
  const Position& corner = first_->item.request.element.end;
  const float left = corner_.before.length - first_->used_mm - trim_mm;
  const bool all_before = left < kCrumbMm;
  const bool all_after = corner_.after.length - trim_mm < kCrumbMm;
  const Position from = all_before ? first_->start : corner_.place(corner, -trim_mm);
  const Position to =
      all_after ? second_->item.request.element.end : corner_.place(corner, trim_mm);
  const Blend blend = make_blend(corner_, from, to, trim_mm, in_halves);
  if (blend.count == 0) return give_rest(*first_, corner, -1.0F);
  give_rest(*first_, from, all_before ? 0.0F : left);
  give_blend(blend, all_before ? first_->joint : motion::Joint::kSmooth, trim_mm, in_halves);
  second_->start = to;
  second_->used_mm = trim_mm;
  second_->joint = motion::Joint::kSmooth;
}

/// Appends the parts of a blend to the settled pieces. @param joint joint with the piece before the
/// blend
void CornerRounder::give_blend(const Blend& blend,
                               motion::Joint joint,
                               float trim_mm,
                               bool in_halves) {
  for (std::size_t i = 0; i < blend.count; ++i) {
    const bool earlier = in_halves && i == 0;
    motion::MotionRequest& part = begin_giving(earlier ? *first_ : *second_);
    if (!in_halves) part.line = first_->item.request.line;
    part.element = blend.parts[i];
    part.row = earlier ? part.row.part(1.0F - trim_mm / corner_.before.length, 1.0F)
                       : part.row.part(0.0F, trim_mm / corner_.after.length);
    if (earlier) part.outputs = {};
    if (!earlier) second_->item.request.outputs = {};
    give(joint);
    joint = motion::Joint::kSmooth;
  }
}

/// Appends the rest of an element to the settled pieces.
/// @param end end of this rest
/// @param left_mm length of this rest; negative for the complete rest of the element
void CornerRounder::give_rest(const HeldItem& held, const Position& end, float left_mm) {
  motion::MotionRequest& request = begin_giving(held);
  const PathElement& whole = held.item.request.element;
  if (held.used_mm > 0.0F || left_mm >= 0.0F) {
    const float length = length_of(whole);
    const float left = left_mm >= 0.0F ? left_mm : length - held.used_mm;
    const float share = length > 0.0F ? left / length : 1.0F;
    become_part(request.element, held.start, end, share);
    if (request.row.any() && length > 0.0F) {
      const float from = held.used_mm / length;
      request.row = request.row.part(from, left_mm >= 0.0F ? from + share : 1.0F);
    }
  }
  give(held.joint);
}

/// Begins the next piece with the request of a whole element. give() completes the piece.
motion::MotionRequest& CornerRounder::begin_giving(const HeldItem& held) {
  CNC_ASSERT(ready_count_ < kMaxReady);
  return ready_[ready_count_].request = held.item.request;
}

/// Completes a piece. A piece that its corners have used up is omitted. Its outputs went with the
/// blend before it. If there was a stop before the omitted piece, there is a stop before the next
/// one.
void CornerRounder::give(motion::Joint joint) {
  PathPiece& piece = ready_[ready_count_];
  stop_left_over_ = stop_left_over_ || joint == motion::Joint::kStop;
  if (piece.request.element.start == piece.request.element.end) return;
  piece.joint = stop_left_over_ ? motion::Joint::kStop : motion::Joint::kSmooth;
  ++ready_count_;
  stop_left_over_ = false;
}

}  // namespace cnc::path
