#include "firmware/machine/reentry.hpp"

#include "planner/path/blend.hpp"
#include "planner/path/passing.hpp"

namespace cnc {

/// Whether it is the part of the line that was driven, or comes after it.
bool Reentry::may_hold(motion::SourceLine line) const {
  if (line.number != line_.number) return line.number > line_.number;
  return line.part >= line_.part;
}

Reentry::Verdict Reentry::judge(path::PathItem& item, float beside_mm) {
  const motion::SourceLine line = item.request.line;
  if (line.number > line_.number + kMostLines) return Verdict::kLost;
  if (!may_hold(line)) return Verdict::kDark;
  PathElement& element = item.request.element;
  const path::Passing passing = path::passing_of(element, place_);
  if (passing.share >= 1.0F || passing.distance_mm > beside_mm) return Verdict::kDark;
  active_ = false;
  if (passing.place == element.start) return Verdict::kLit;
  rest_ = item;
  rest_.request.element = path::part_of(element, passing.place, element.end, 1.0F - passing.share);
  rest_.request.outputs = {};
  rest_.continues = true;
  has_rest_ = true;
  element = path::part_of(element, element.start, passing.place, passing.share);
  return Verdict::kSplit;
}

}  // namespace cnc
