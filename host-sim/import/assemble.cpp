#include <cmath>

#include "host-sim/import/curve_measure.hpp"
#include "host-sim/import/filling.hpp"
#include "host-sim/import/piece.hpp"

namespace sim::drawing {
namespace {

// A beam is wider than this; what is narrower is a line drawn there and back.
constexpr double kLeastWidthMm = 0.001;

// A third of a gigabyte: a hundred thousand holes of a millimetre and more.
constexpr std::size_t kMostPlaces = 20'000'000;

std::vector<Piece> pieces_of(Sketch& sketch) {
  std::vector<Piece> pieces;
  pieces.reserve(sketch.chains().size());
  const std::size_t most = sketch.share_of(kMostPlaces);
  std::size_t places = 0;
  for (Chain& chain : sketch.chains()) {
    Piece piece;
    piece.contour.shapes = std::move(chain.shapes);
    piece.contour.entity = sketch.entity(chain.entity);
    measure(piece);
    places += piece.outline.size();
    if (places > most) {
      sketch.report({FaultKind::kTooMuch,
                     piece.contour.entity,
                     {},
                     "more curves than can be compared; this and what follows is left out",
                     "cut the drawing in parts"});
      break;
    }
    pieces.push_back(std::move(piece));
  }
  sketch.chains().clear();
  return pieces;
}

/// What crosses itself may have no area in sum, and is reported already.
void drop_flat(Sketch& sketch, std::vector<Piece>& pieces, const std::vector<bool>& crossed) {
  std::vector<Piece> kept;
  kept.reserve(pieces.size());
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const DrawnContour& contour = pieces[i].contour;
    const double width = 2.0 * std::abs(contour.area_mm2) / contour.length_mm;
    if (contour.closed && !crossed[i] && width < kLeastWidthMm) {
      sketch.report({FaultKind::kTooSmall,
                     contour.entity,
                     pieces[i].outline.front(),
                     "the contour is closed and has no area",
                     "it is left out; delete it, or leave it open to draw a line"});
      continue;
    }
    kept.push_back(std::move(pieces[i]));
  }
  pieces = std::move(kept);
}

}  // namespace

Drawing assemble(Sketch& sketch, const std::string& file, double gap_mm) {
  std::vector<Piece> pieces = pieces_of(sketch);
  drop_duplicates(sketch, pieces, gap_mm);
  pieces = join(sketch, std::move(pieces), gap_mm);
  drop_duplicates(sketch, pieces, gap_mm);
  const std::vector<bool> crossed = fill(sketch, pieces);
  drop_flat(sketch, pieces, crossed);
  find_coincident(sketch, pieces, gap_mm);
  nest(sketch, pieces);
  sketch.finish();
  Drawing drawing;
  drawing.file = file;
  drawing.layers = std::move(sketch.layers());
  drawing.contours.reserve(pieces.size());
  for (Piece& piece : pieces) drawing.contours.push_back(std::move(piece.contour));
  drawing.faults = std::move(sketch.faults());
  drawing.more_faults = sketch.more_faults();
  return drawing;
}

}  // namespace sim::drawing
