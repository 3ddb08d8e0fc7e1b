#include "planner/motion/segment/pixel_course.hpp"

#include <algorithm>

namespace cnc::motion {

void PixelCourse::begin(const Block& block, PathUnits length) {
  row_ = block.row;
  length_ = length;
  change_ = length;
  duty_ = block.beam.duty;
  line_ = block.line;
  if (!row_.any()) return;
  CNC_ASSERT(pixels_ != nullptr);
  pixels_->drop_before(row_.first);
  scale_ = block.length / (row_.to_mm - row_.from_mm);
  take_front();
  pass(0);
}

/// Marks the pixels before `place` as driven. At the end of the block, also marks the last pixel if
/// it ends there and does not continue in the next block.
void PixelCourse::pass(PathUnits place) {
  if (!row_.any()) return;
  while (change_ <= place && change_ < length_) {
    pixels_->pop();
    take_front();
  }
  if (place == length_ && pixels_->front().end_mm <= row_.to_mm) pixels_->pop();
}

void PixelCourse::take_front() {
  const Pixel& pixel = pixels_->front();
  duty_ = pixel.duty;
  line_ = pixel.line;
  change_ = length_;
  if (pixel.end_mm >= row_.to_mm) return;
  const float from_start = std::max(0.0F, pixel.end_mm - row_.from_mm) * scale_;
  change_ = std::min(to_units(from_start), length_);
}

SourceLine line_of(const Block& block, const Pixels& pixels) {
  const bool known = block.row.any() && !pixels.empty();
  const bool of_its_row = known && static_cast<std::int32_t>(pixels.first() - block.row.first) >= 0;
  return of_its_row ? pixels.front().line : block.line;
}

}  // namespace cnc::motion
