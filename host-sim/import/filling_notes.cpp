#include "host-sim/import/filling_notes.hpp"

#include <fmt/format.h>

#include <string>

namespace sim::drawing {
namespace {

/// Least total length of edges on no outline that a note reports, mm. Shorter edges result from
/// rounding.
constexpr double kUnseenRoundingMm = 0.01;
constexpr LeastLoop kMinLoop{};

std::string text_of(const FilledSet& filled, std::size_t contours) {
  std::string text =
      contours == 1 ? std::string{"the contour crosses itself or runs along itself"}
                    : fmt::format("{} contours cross each other or run along each other", contours);
  const std::size_t outlines = filled.outlines.loop_ends.size();
  text += fmt::format(
      ": replaced by {} outline{} of the filled area", outlines, outlines == 1 ? "" : "s");
  if (filled.small_loops != 0) {
    text += fmt::format(
        "; {} loop{} smaller than {} mm2 or narrower than {} mm left out; the largest has "
        "{:.4f} mm2 and is at {:.3f} {:.3f}",
        filled.small_loops,
        filled.small_loops == 1 ? "" : "s",
        kMinLoop.area_mm2,
        kMinLoop.width_mm,
        filled.greatest_small.size,
        filled.greatest_small.place.x(),
        filled.greatest_small.place.y());
  }
  if (filled.unseen_mm > kUnseenRoundingMm) {
    text += fmt::format(
        "; {:.3f} mm of lines that do not bound this area are left out; the "
        "longest has {:.3f} mm and is at {:.3f} {:.3f}",
        filled.unseen_mm,
        filled.longest_unseen.size,
        filled.longest_unseen.place.x(),
        filled.longest_unseen.place.y());
  }
  return text;
}

}  // namespace

void FillingNotes::add(const std::vector<Piece>& pieces,
                       const std::vector<std::size_t>& from,
                       const FilledSet& filled) {
  const Piece& first = pieces[from.front()];
  const bool is_small = filled.small_loops != 0 && filled.unseen_mm <= kUnseenRoundingMm &&
                        filled.outlines.loop_ends.size() == from.size();
  if (is_small) {
    if (!first_) first_ = first.contour.entity;
    mended_ += from.size();
    loops_ += filled.small_loops;
    greatest_.take_greater(filled.greatest_small.size, filled.greatest_small.place);
    return;
  }
  if (++notes_ > kMaxNotes) {
    ++more_;
    more_unseen_mm_ += filled.unseen_mm;
    return;
  }
  sketch_.report(
      {FaultKind::kMended,
       first.contour.entity,
       filled.unseen_mm > kUnseenRoundingMm ? filled.longest_unseen.place : filled.crossing,
       text_of(filled, from.size()),
       "separate the contours in the drawing if another area is meant"});
}

void FillingNotes::finish() {
  if (mended_ != 0) {
    const std::string whose =
        mended_ == 1
            ? std::string{"the contour has loops where it crosses itself"}
            : fmt::format(
                  "{} contours, of which this is the first, have loops where they cross themselves",
                  mended_);
    sketch_.report({FaultKind::kMended,
                    *first_,
                    greatest_.place,
                    fmt::format("{}: {} smaller than {} mm2 or narrower than {} mm left out; "
                                "the largest has {:.4f} mm2 and is here",
                                whose,
                                loops_,
                                kMinLoop.area_mm2,
                                kMinLoop.width_mm,
                                greatest_.size),
                    {}});
  }
  if (more_ != 0) {
    sketch_.report(
        {FaultKind::kMended,
         {},
         {},
         fmt::format(
             "{} more sets of crossing contours are replaced by outlines of the filled area; "
             "{:.3f} mm of lines that do not bound this area are left out",
             more_,
             more_unseen_mm_),
         {}});
  }
}

}  // namespace sim::drawing
