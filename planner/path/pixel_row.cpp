#include "planner/path/pixel_row.hpp"

#include <algorithm>
#include <cmath>

#include "planner/base/contract.hpp"
#include "planner/base/scalar_math.hpp"

namespace cnc::path {
namespace {

/// Allowance for the rounding of ends to nanometres and for the rounding of single precision, mm.
constexpr float kRowRoundingMm = 3.0e-6F;
// Additional allowance for single precision as a share of the distance from the start of the row.
constexpr float kRelativeError = 3.0e-7F;

bool can_be_gathered(const PathItem& item) {
  const motion::MotionRequest& request = item.request;
  return request.element.bulge == 0.0F && request.feed_mm_s > 0.0F && !request.fixed_feed &&
         !item.continues && !request.row.any();
}

bool same_tolerance(const Tolerance& a, const Tolerance& b) {
  return a.corner_mm == b.corner_mm && a.weld_mm == b.weld_mm;
}

}  // namespace

void PixelRow::begin(const PathItem& item) {
  CNC_ASSERT(empty());
  item_ = item;
  held_ = true;
  // If the previous row was closed because it was full, the new row continues it. Then the new row
  // counts as graded if the previous row had several powers.
  graded_ = graded_ && full_;
  full_ = false;
  has_pixels_ = false;
  closed_ = pixels_ == nullptr || !can_be_gathered(item);
  if (closed_) return;
  const motion::MotionRequest& request = item.request;
  way_ = way_to(request.element.end);
  closed_ = way_.length > kLongestLineMm;
  if (closed_) return;
  leading_ = 0;
  for (std::size_t axis = 1; axis < kAxisCount; ++axis) {
    if (std::abs(way_.travel[axis]) > std::abs(way_.travel[leading_])) leading_ = axis;
  }
  lines_ = 1;
  pixel_ = {.end_mm = way_.length, .duty = request.beam.duty, .line = request.line};
  slopes_known_ = false;
}

bool PixelRow::add(const PathItem& item) {
  const motion::MotionRequest& next = item.request;
  if (!held_ || closed_ || !can_be_gathered(item)) return false;
  const bool same_power = next.beam.duty == pixel_.duty;
  if (!same_tolerance(item.tolerance, item_.tolerance) || !may_go_on(next, same_power)) {
    return false;
  }
  const bool graded = graded_ || !same_power;
  const bool stops_at_corners = item_.tolerance.corner_mm <= 0.0F;
  const float aside = graded && !stops_at_corners ? kMaxAsideMm : 0.0F;
  if (graded != graded_) slopes_known_ = false;
  if (!slopes_known_) limit_slopes(aside);
  const Way way = way_to(next.element.end);
  if (!straight_on(way)) return false;
  graded_ = graded;
  if (!same_power || next.line != pixel_.line) {
    give_pixel();
    pixel_ = {.duty = next.beam.duty, .line = next.line};
  }
  way_ = way;
  item_.request.element.end = next.element.end;
  pixel_.end_mm = way.length;
  limit_slopes(aside);
  if (++lines_ < kMaxLines) return true;
  close();
  full_ = true;
  return true;
}

/// Returns whether a line may continue the row. Lines of constant power that may be welded are left
/// for the welder.
bool PixelRow::may_go_on(const motion::MotionRequest& next, bool same_power) const {
  const motion::MotionRequest& row = item_.request;
  const bool for_welder = item_.tolerance.weld_mm > 0.0F && same_power && !graded_;
  return next.feed_mm_s == row.feed_mm_s && !next.outputs.any() &&
         next.beam.follows_speed == row.beam.follows_speed && next.beam.beside == row.beam.beside &&
         !for_welder;
}

/// Returns whether the row can be extended to a new end: it passes near all ends of lines so far,
/// does not turn back, and is not too long. @param way travel from the start of the row to this end
bool PixelRow::straight_on(const Way& way) const {
  const float so_far = way_.travel[leading_];
  const float reach = way.travel[leading_];
  if (!((reach - so_far) * so_far > 0.0F) || way.length > kMaxRowMm) return false;
  if (way.length - way_.length > kLongestLineMm) return false;
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    const float slope = way.travel[axis] / reach;
    if (slope < slopes_[axis].least || slope > slopes_[axis].most) return false;
  }
  return true;
}

/// Limits the slopes so that the row passes its present end within `aside_mm`.
void PixelRow::limit_slopes(float aside_mm) {
  const float per_mm = 1.0F / way_.travel[leading_];
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    const float travel = way_.travel[axis];
    const float aside = aside_mm + kRowRoundingMm + kRelativeError * std::abs(travel);
    const float middle = travel * per_mm;
    const float half = aside * std::abs(per_mm);
    SlopeRange& range = slopes_[axis];
    range.least = slopes_known_ ? std::max(range.least, middle - half) : middle - half;
    range.most = slopes_known_ ? std::min(range.most, middle + half) : middle + half;
  }
  slopes_known_ = true;
}

bool PixelRow::can_be_row(const PathElement& line, std::size_t pixels) {
  return pixels >= kFewestOfARow && line.bulge == 0.0F &&
         norm(travel_between(line.start, line.end)) <= kMaxRowMm;
}

void PixelRow::become_row(PathItem& item, const RowPowers& powers) {
  close();
  motion::MotionRequest& request = item.request;
  const std::size_t count = powers.values.size();
  const float length = norm(travel_between(request.element.start, request.element.end));
  const float width = length / static_cast<float>(count);
  request.row = {.first = pixels_->next(), .to_mm = length};
  for (std::size_t i = 0; i < count; ++i) {
    const auto part = static_cast<std::uint32_t>(i + 1);
    pixels_->push({.end_mm = part == count ? length : width * static_cast<float>(part),
                   .duty = powers.duty(i),
                   .line = {request.line.number, part}});
  }
}

void PixelRow::give_pixel() {
  if (!has_pixels_) item_.request.row.first = pixels_->next();
  has_pixels_ = true;
  pixels_->push(pixel_);
}

void PixelRow::close() {
  if (!held_ || closed_) return;
  closed_ = true;
  if (!has_pixels_) return;
  give_pixel();
  item_.request.row.from_mm = 0.0F;
  item_.request.row.to_mm = way_.length;
}

void PixelRow::clear() {
  let_go();
  full_ = false;
}

PixelRow::Way PixelRow::way_to(const Position& place) const {
  const Position& start = item_.request.element.start;
  Way way;
  float sum = 0.0F;
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    if (place[axis] == start[axis]) continue;
    way.travel[axis] = (place[axis] - start[axis]).mm();
    sum += square(way.travel[axis]);
  }
  way.length = std::sqrt(sum);
  return way;
}

}  // namespace cnc::path
