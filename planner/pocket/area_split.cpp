#include "planner/pocket/area_split.hpp"

#include <cmath>

#include "planner/pocket/loop_measures.hpp"

namespace cnc::pocket {
namespace {

using contour::ContourView;
using contour::kNone;
using contour::Slice;

/// Returns a box around a loop. Each arc is inside the box around its ends, widened by the arc's
/// height.
template <typename Scalar>
contour::FlatBox<Scalar> box_around(const ContourView<Scalar>& contour, std::size_t loop) {
  const BasicVec2<Scalar> first = contour.vertices[contour.loop_begin(loop)].point();
  contour::FlatBox<Scalar> box{first.x(), first.y(), first.x(), first.y()};
  for (std::uint32_t i = contour.loop_begin(loop); i < contour.loop_ends[loop]; ++i) {
    const LoopElement<Scalar> element = element_at(contour, loop, i);
    const Scalar height =
        Scalar{0.5} * std::abs(element.bulge) * (element.end - element.start).norm();
    box.include({std::min(element.start.x(), element.end.x()) - height,
                 std::min(element.start.y(), element.end.y()) - height,
                 std::max(element.start.x(), element.end.x()) + height,
                 std::max(element.start.y(), element.end.y()) + height});
  }
  return box;
}

/// Returns the middle of the longest element. Of all points of the loop it is the least likely to
/// be on another loop.
template <typename Scalar>
BasicVec2<Scalar> typical_point(const ContourView<Scalar>& contour, std::size_t loop) {
  LoopElement<Scalar> longest = element_at(contour, loop, contour.loop_begin(loop));
  for (std::uint32_t i = contour.loop_begin(loop) + 1; i < contour.loop_ends[loop]; ++i) {
    const LoopElement<Scalar> element = element_at(contour, loop, i);
    if ((element.end - element.start).squaredNorm() > (longest.end - longest.start).squaredNorm()) {
      longest = element;
    }
  }
  return longest.middle();
}

template <typename Scalar>
bool is_outline(const LoopNote<Scalar>& note) {
  return note.area >= Scalar{kMinArea};
}

template <typename Scalar>
bool is_hole(const ContourView<Scalar>& contour, std::size_t loop, Scalar area) {
  if (area > -Scalar{kMinArea}) return false;
  Scalar length{0};
  for (std::uint32_t i = contour.loop_begin(loop); i < contour.loop_ends[loop]; ++i) {
    length += length_of(element_at(contour, loop, i));
  }
  return -area > Scalar{0.5 * kMinHoleWidth} * length;
}

template <typename Scalar>
std::uint32_t owner_of(const ContourView<Scalar>& contour,
                       Slice<LoopNote<Scalar>> notes,
                       std::uint32_t hole) {
  const BasicVec2<Scalar> point = typical_point(contour, hole);
  std::uint32_t best = kNone;
  for (std::uint32_t i = 0; i < contour.loop_ends.size(); ++i) {
    const LoopNote<Scalar>& note = notes[i];
    if (!is_outline(note) || (best != kNone && note.area >= notes[best].area)) continue;
    if (!note.box.meets({point.x(), point.y(), point.x(), point.y()})) continue;
    if (turns_around(contour, i, point) > 0) best = i;
  }
  return best;
}

/// Stores the area of each loop and the box around each outline. Returns the number of outlines.
template <typename Scalar>
std::uint32_t measure_loops(const ContourView<Scalar>& contour, Slice<LoopNote<Scalar>> notes) {
  std::uint32_t outlines = 0;
  for (std::uint32_t i = 0; i < contour.loop_ends.size(); ++i) {
    notes[i] = {signed_area(contour, i)};
    if (!is_outline(notes[i])) continue;
    notes[i].box = box_around(contour, i);
    ++outlines;
  }
  return outlines;
}

template <typename Scalar>
bool assign_holes(const ContourView<Scalar>& contour,
                  Slice<LoopNote<Scalar>> notes,
                  std::uint32_t outlines) {
  std::uint32_t only = 0;
  while (outlines == 1 && !is_outline(notes[only])) ++only;
  for (std::uint32_t i = 0; i < contour.loop_ends.size(); ++i) {
    if (!is_hole(contour, i, notes[i].area)) continue;
    const std::uint32_t owner = outlines == 1 ? only : owner_of(contour, notes, i);
    if (owner == kNone) return false;
    notes[i].next_hole = notes[owner].first_hole;
    notes[owner].first_hole = i;
  }
  return true;
}

}  // namespace

template <typename Scalar>
SplitResult split_areas(const ContourView<Scalar>& contour,
                        Slice<LoopNote<Scalar>> notes,
                        AreaList<Scalar>& out) {
  if (contour.loop_ends.size() > notes.size()) return SplitResult::kFull;
  const std::uint32_t outlines = measure_loops(contour, notes);
  if (!assign_holes(contour, notes, outlines)) return SplitResult::kNoOwner;
  for (std::uint32_t i = 0; i < contour.loop_ends.size(); ++i) {
    if (!is_outline(notes[i])) continue;
    if (!out.begin_area() || !out.add_loop(contour, i)) return SplitResult::kFull;
    for (std::uint32_t hole = notes[i].first_hole; hole != kNone; hole = notes[hole].next_hole) {
      if (!out.add_loop(contour, hole)) return SplitResult::kFull;
    }
  }
  return SplitResult::kDone;
}

template SplitResult split_areas(const ContourView<double>&,
                                 Slice<LoopNote<double>>,
                                 AreaList<double>&);

}  // namespace cnc::pocket
