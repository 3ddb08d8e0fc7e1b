#include "firmware/machine/reentry.hpp"

#include "planner/path/blend.hpp"
#include "planner/path/passing.hpp"

namespace cnc {

namespace {

/// Maximum distance of the point from the end of an element, mm, at which the element counts as
/// driven completely before the interruption. It is one or two steps.
constexpr float kAtEndMm = 0.02F;

}  // namespace

/// Returns whether elements of `line` may contain the point: `line` is the noted line, from the
/// noted part on, or a later line.
bool Reentry::may_hold(motion::SourceLine line) const {
  if (line.number != line_.number) return line.number > line_.number;
  return line.part >= line_.part;
}

Reentry::Verdict Reentry::judge(path::PathItem& item, float beside_mm) {
  const motion::SourceLine line = item.request.line;
  if (line.number > line_.number + kMaxLines) return Verdict::kLost;
  if (!may_hold(line)) return Verdict::kDark;
  PathElement& element = item.request.element;
  const path::Passing passing = path::passing_of(element, place_);
  if (passing.distance_mm > beside_mm) return Verdict::kDark;
  const bool at_end = passing.share >= 1.0F;
  if (at_end && passing.distance_mm > kAtEndMm) return Verdict::kDark;
  active_ = false;
  if (at_end) return Verdict::kDark;
  if (passing.place == element.start) return Verdict::kLit;
  rest_ = item;
  path::become_part(rest_.request.element, passing.place, element.end, 1.0F - passing.share);
  rest_.request.outputs = {};
  rest_.continues = true;
  has_rest_ = true;
  path::become_part(element, element.start, passing.place, passing.share);
  return Verdict::kSplit;
}

}  // namespace cnc
