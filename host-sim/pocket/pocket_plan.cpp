#include "host-sim/pocket/pocket_plan.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace sim::pocket {
namespace {

using cnc::contour::OffsetFault;
using cnc::pocket::ClearingError;
using cnc::pocket::ClearingFault;
using cnc::pocket::PocketFault;

bool is_full(const ClearingError& error) {
  if (error.fault == ClearingFault::kTooManyLoops) return true;
  return error.fault == ClearingFault::kOffset && error.offset.fault != OffsetFault::kNotANumber &&
         error.offset.fault != OffsetFault::kNotClosed;
}

[[noreturn]] void refuse(const ContourVertex& begin, const char* reason, const char* remedy) {
  throw NoPocketPath{fmt::format("the pocket whose contour begins at {:.3f} {:.3f}: {}; {}",
                                 begin.x,
                                 begin.y,
                                 reason,
                                 remedy)};
}

[[noreturn]] void refuse_clearing(const ClearingError& error, const ContourVertex& begin) {
  switch (error.fault) {
    case ClearingFault::kOptionOutOfRange:
      throw std::invalid_argument{
          "radius, stepover or corner radius of the passes is out of range"};
    case ClearingFault::kLoopsCross:
      refuse(begin, "its contours cross each other", "separate them");
    default:
      refuse(begin,
             "it has no offset",
             "check for contours that cross and for coordinates that are not finite");
  }
}

}  // namespace

void PocketPlanner::Loops::resize(std::size_t size) {
  vertices.resize(size);
  loop_ends.resize(size);
}

cnc::pocket::LoopSpace<double> PocketPlanner::Loops::slices() {
  return {slice_of(vertices), slice_of(loop_ends)};
}

void PocketPlanner::Areas::resize(std::size_t size) {
  vertices.resize(size);
  loop_ends.resize(size);
  ranges.resize(size);
}

cnc::pocket::AreaSpace<double> PocketPlanner::Areas::slices() {
  return {slice_of(vertices), slice_of(loop_ends), slice_of(ranges)};
}

void PocketPlanner::grow(std::size_t elements) {
  elements_ = elements;
  offset_.grow(elements, 4 * elements);
  for (Loops* loops : {&loops_, &inner_, &grown_}) loops->resize(elements);
  for (Areas* areas : {&left_, &goals_}) areas->resize(elements);
  notes_.resize(elements);
  driven_loops_ = std::make_unique<bool[]>(elements);  // NOLINT(modernize-avoid-c-arrays)
  locus_.resize(elements);
  locus_boxes_.resize(offset_.space().element_boxes.size());
}

void PocketPlanner::grow_passes(std::size_t elements) {
  passes_.resize(elements);
  pass_notes_.resize(elements);
  states_.resize(elements);
}

void PocketPlanner::grow_path(std::size_t points) {
  points_.resize(points);
  row_ends_.resize(points);
}

cnc::pocket::PocketPathSpace<double> PocketPlanner::space() {
  return {{offset_.space(),
           loops_.slices(),
           inner_.slices(),
           grown_.slices(),
           left_.slices(),
           goals_.slices(),
           slice_of(notes_)},
          slice_of(states_),
          {driven_loops_.get(), elements_},
          slice_of(locus_),
          slice_of(locus_boxes_)};
}

void PocketPlanner::grow_or_refuse(const cnc::pocket::PocketError& error,
                                   const ContourVertex& begin) {
  const bool passes_are_full = error.fault == PocketFault::kClearing &&
                               error.clearing.fault == ClearingFault::kPassesTooLong;
  if (std::max(pass_notes_.size(), points_.size()) > kMaxPoints) {
    refuse(begin, "its path is too long", "choose a larger tool, stepover or depth step");
  }
  if (passes_are_full) return grow_passes(2 * pass_notes_.size());
  switch (error.fault) {
    case PocketFault::kPathTooLong:
      return grow_path(2 * points_.size());
    case PocketFault::kOptionOutOfRange:
      throw std::invalid_argument{"depth, depth step, slope or helix radius is out of range"};
    case PocketFault::kToolTooLarge:
      refuse(begin, "the tool fits nowhere into it", "choose a smaller one with --tool");
    case PocketFault::kNoEntry:
      refuse(begin,
             "a pass is too short for a ramp, and no helix fits",
             "choose --entry plunge or a smaller tool");
    case PocketFault::kClearing:
      if (!is_full(error.clearing)) refuse_clearing(error.clearing, begin);
      break;
    case PocketFault::kSpaceTooSmall:
      break;
  }
  if (elements_ >= kMaxElements) {
    refuse(
        begin, "its passes have too many elements", "simplify the drawing, or raise --tolerance");
  }
  grow(std::min(2 * elements_, kMaxElements));
}

PocketPlan PocketPlanner::plan(const cnc::contour::ContourView<double>& pocket,
                               const cnc::pocket::PocketOptions<double>& options) {
  if (pocket.vertices.size() == 0) throw NoPocketPath{"the pocket has no contour; draw one"};
  const std::size_t at_first = std::min(2 * pocket.vertices.size() + 128, kMaxElements);
  if (elements_ < at_first) grow(at_first);
  if (pass_notes_.empty()) grow_passes(4 * at_first);
  if (points_.empty()) grow_path(4 * at_first);
  for (;;) {
    cnc::pocket::PassList<double> passes{passes_.slices().list(), slice_of(pass_notes_)};
    cnc::pocket::ToolPathWriter<double> out{slice_of(points_), slice_of(row_ends_)};
    const auto result =
        cnc::pocket::write_pocket_path<double>(pocket, options, space(), passes, out);
    if (!result.ok()) {
      grow_or_refuse(result.error(), pocket.vertices[0]);
      continue;
    }
    PocketPlan plan;
    plan.report = result.value();
    const auto path = out.view();
    plan.points.assign(path.points.begin(), path.points.end());
    plan.row_ends.assign(path.row_ends.begin(), path.row_ends.end());
    for (std::size_t i = 0; i < passes.size(); ++i) {
      plan.passes.push_back(copy_of(passes.loops(i)));
      plan.parents.push_back(passes.note(i).parent);
    }
    return plan;
  }
}

}  // namespace sim::pocket
