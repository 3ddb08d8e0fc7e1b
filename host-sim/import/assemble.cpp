#include <fmt/format.h>

#include <cmath>

#include "host-sim/import/curve_measure.hpp"
#include "host-sim/import/drawing_unit.hpp"
#include "host-sim/import/filled_set.hpp"
#include "host-sim/import/filling.hpp"
#include "host-sim/import/piece.hpp"
#include "host-sim/import/wider_gap.hpp"

namespace sim::drawing {
namespace {

// Smallest mean width at which a closed contour counts as an area, mm. A contour below this width
// is narrower than any beam, and is treated as a line that is drawn forth and back.
constexpr double kMinWidthMm = 0.001;

// Greatest number of points of all outlines together. This number of points takes a third of a
// gigabyte of memory. It suffices for more than a hundred thousand holes with a diameter of a
// millimetre.
constexpr std::size_t kMaxPlaces = 20'000'000;

std::vector<Piece> pieces_of(Sketch& sketch) {
  std::vector<Piece> pieces;
  pieces.reserve(sketch.chains().size());
  const std::size_t most = sketch.share_of(kMaxPlaces);
  std::size_t places = 0;
  for (Chain& chain : sketch.chains()) {
    Piece piece;
    piece.contour.shapes = std::move(chain.shapes);
    piece.contour.entity = sketch.entity(chain.entity);
    measure(piece);
    places += piece.outline.size();
    if (places > most) {
      sketch.report(
          {FaultKind::kTooMuch,
           piece.contour.entity,
           {},
           "there are more curves than can be compared; this curve and all later ones are left out",
           "divide the drawing into several files"});
      break;
    }
    pieces.push_back(std::move(piece));
  }
  sketch.chains().clear();
  return pieces;
}

/// Returns the fault of a closed contour whose mean width `width_mm` is smaller than any beam,
/// because its path runs forth and back along nearly the same line.
Fault dense(const Piece& piece, double width_mm) {
  const DrawnContour& contour = piece.contour;
  return {
      FaultKind::kTooSmall,
      contour.entity,
      piece.outline.front(),
      fmt::format(
          "the contour runs to and fro: {:.3f} mm2 in {:.0f} mm of path, {:.2g} mm wide on average",
          std::abs(contour.area_mm2),
          contour.length_mm,
          width_mm),
      "it is left out; simplify it, or leave it open to draw a line"};
}

/// Reports a closed contour without area as a line or as left out. If its outline is painted, the
/// contour is visible as a line and is kept as an open contour. Otherwise the contour is not
/// visible, and is dropped. Returns whether the contour is kept.
bool keep_as_line(Sketch& sketch, Piece& piece) {
  const Place& place = piece.outline.front();
  const std::string reason = "the contour is closed and has no area";
  if (!piece.contour.entity.has_outline) {
    sketch.report({FaultKind::kMended,
                   piece.contour.entity,
                   place,
                   reason,
                   "it is left out; give it a stroke to draw a line"});
    return false;
  }
  piece.contour.closed = false;
  sketch.report({FaultKind::kOpen,
                 piece.contour.entity,
                 place,
                 reason,
                 "it is read as a line; leave it open, or delete it",
                 true});
  return true;
}

/// Removes closed contours without area, or keeps them as lines. Skips contours that cross
/// themselves: parts of their signed area may cancel, and they were already reported.
void drop_flat(Sketch& sketch, std::vector<Piece>& pieces, const std::vector<bool>& crossed) {
  std::vector<Piece> kept;
  kept.reserve(pieces.size());
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const DrawnContour& contour = pieces[i].contour;
    const double width = 2.0 * std::abs(contour.area_mm2) / contour.length_mm;
    if (contour.closed && !crossed[i] && width < kMinWidthMm) {
      if (std::abs(contour.area_mm2) >= LeastLoop{}.area_mm2) {
        sketch.report(dense(pieces[i], width));
        continue;
      }
      if (!keep_as_line(sketch, pieces[i])) continue;
    }
    kept.push_back(std::move(pieces[i]));
  }
  pieces = std::move(kept);
}

OutlineBox box_around(const std::vector<Piece>& pieces) {
  OutlineBox box;
  for (const Piece& piece : pieces) {
    box.include(piece.box.least);
    box.include(piece.box.most);
  }
  return box;
}

/// The greatest gap that is joined, mm, and the remedy in messages about ends that stay open.
struct GapToJoin {
  double gap_mm;
  std::string remedy;
};

GapToJoin gap_to_join(Sketch& sketch,
                      const std::vector<Piece>& pieces,
                      const ImportOptions& options) {
  GapToJoin gap{options.gap_mm, fmt::format("join gaps wider than {} mm", options.gap_mm)};
  const auto wider = wider_gap(pieces, options.gap_mm);
  if (!wider) return gap;
  const std::string closed =
      fmt::format("{} of {} open ends within {} mm", wider->closing, wider->open, wider->gap_mm);
  if (options.finds_gap) {
    sketch.note(fmt::format("gaps up to {} mm are joined, which closes {}", wider->gap_mm, closed),
                {},
                "check the joints, or set the gap with --gap");
    return {wider->gap_mm, fmt::format("join gaps wider than {} mm", wider->gap_mm)};
  }
  gap.remedy = fmt::format(
      "join wider gaps: --gap {} closes {}, and --gap auto uses this gap", wider->gap_mm, closed);
  return gap;
}

}  // namespace

Drawing assemble(Sketch& sketch,
                 const std::string& file,
                 const ImportOptions& options,
                 double mm_per_unit) {
  std::vector<Piece> pieces = pieces_of(sketch);
  question_scale(sketch, box_around(pieces), mm_per_unit);
  drop_duplicates(sketch, pieces, options.gap_mm);
  const GapToJoin gap = gap_to_join(sketch, pieces, options);
  const double gap_mm = gap.gap_mm;
  pieces = join(sketch, std::move(pieces), gap_mm, options.mends_gaps, gap.remedy);
  drop_duplicates(sketch, pieces, gap_mm);
  const std::vector<bool> crossed = fill(sketch, pieces, options.refuses_crossings);
  drop_flat(sketch, pieces, crossed);
  find_coincident(sketch, pieces, gap_mm);
  nest(sketch, pieces);
  sketch.finish();
  Drawing drawing;
  drawing.file = file;
  drawing.layers = std::move(sketch.layers());
  drawing.contours.reserve(pieces.size());
  for (Piece& piece : pieces) drawing.contours.push_back(std::move(piece.contour));
  drawing.pictures = std::move(sketch.pictures());
  drawing.faults = std::move(sketch.faults());
  drawing.more_faults = sketch.more_faults();
  drawing.more_lines = sketch.more_lines();
  return drawing;
}

}  // namespace sim::drawing
