#include "planner/path/short_lines.hpp"

#include <algorithm>
#include <cmath>

#include "planner/base/contract.hpp"

namespace cnc::path {
namespace {

/// Returns whether the element after a short line may begin at the start of that line. An arc must
/// keep its own start, because its radius depends on it. Outputs of the short line require a
/// motion, so the joined element must not end at its start.
bool goes_with(const motion::MotionRequest& line, const motion::MotionRequest& next) {
  const bool comes_back = line.element.start == next.element.end;
  if (next.element.bulge != 0.0F || (comes_back && line.outputs.any())) return false;
  return line.feed_mm_s == next.feed_mm_s && line.beam == next.beam &&
         line.fixed_feed == next.fixed_feed && !next.outputs.any() && !line.row.any() &&
         !next.row.any();
}

}  // namespace

bool ShortLines::is_short(const PathElement& element) const {
  constexpr float kHalfStep = 0.5F;
  if (element.bulge != 0.0F) return false;
  const AxisVector way = travel_between(element.start, element.end);
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    if (std::abs(way[axis]) * limits_.scale[axis].steps_per_mm() >= kHalfStep) return false;
  }
  return true;
}

void ShortLines::put(const PathItem& item) {
  CNC_ASSERT(has_room());
  if (count_ > 0 && goes_with(item_at(0).request, item.request)) {
    go_with_held(item);
  } else {
    item_at(count_++) = item;
  }
  const bool holds_on = is_short(item_at(count_ - 1).request.element);
  settled_ = holds_on ? count_ - 1 : count_;
  drop_still();
}

/// Replaces the held line by the item. The item then begins at the start of the held line.
void ShortLines::go_with_held(const PathItem& item) {
  PathItem& held = item_at(0);
  const Position start = held.request.element.start;
  const motion::OutputChanges outputs = held.request.outputs;
  const float aside = norm(travel_between(start, item.request.element.start));
  const float farthest = std::max(aside, held.aside_mm);
  held = item;
  held.request.element.start = start;
  held.request.outputs = outputs;
  held.aside_mm = farthest;
}

void ShortLines::flush() {
  CNC_ASSERT(has_room());
  settled_ = count_;
  drop_still();
}

/// Drops the oldest item if it does not move. This happens if joined lines end at their start.
void ShortLines::drop_still() {
  const PathElement& element = item_at(0).request.element;
  if (settled_ > 0 && element.start == element.end) forget_oldest();
}

void ShortLines::forget_oldest() {
  oldest_ = (oldest_ + 1) % 2;
  --count_;
  --settled_;
}

const PathItem* ShortLines::next() {
  if (has_room()) return nullptr;
  const PathItem* const item = &item_at(0);
  forget_oldest();
  return item;
}

motion::SourceLine ShortLines::line() const {
  return empty() ? motion::SourceLine{} : items_[oldest_].request.line;
}

}  // namespace cnc::path
