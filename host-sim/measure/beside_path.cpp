#include "host-sim/measure/beside_path.hpp"

#include <algorithm>

#include "host-sim/measure/path_items.hpp"

namespace sim {

void BesideWay::put(const PathPiece& piece) {
  if (!piece.beside) return leave(piece);
  if (!compensator_->active()) {
    compensator_->begin(item_of(piece).request.element.start,
                        piece.beside->plane,
                        static_cast<float>(piece.beside->offset_mm));
    stops_ = piece.stop_before;
  }
  if (refused_) return;
  refused_ = compensator_->put(item_of(piece)).has_value();
  take();
}

void BesideWay::end() {
  if (!compensator_->active()) return;
  if (!refused_ && !compensator_->end()) take();
  compensator_->clear();
  refused_ = false;
}

/// The first piece after G40 begins beside the path, as the rest does not.
void BesideWay::leave(const PathPiece& piece) {
  const bool exit = compensator_->active();
  end();
  if (!exit || !last_end_) return pass_on(piece);
  PathPiece way_back = piece;
  way_back.curve = Curve::line(*last_end_, piece.curve.end());
  pass_on(way_back);
}

void BesideWay::take() {
  cnc::path::PathItem item;
  while (!refused_ && compensator_->take(item)) {
    PathPiece piece = piece_of(item.request.element, item.request.feed_mm_s, stops_);
    set_beam(piece, item.request.beam);
    piece.line = static_cast<int>(item.request.line.number);
    piece.tolerance.corner = static_cast<double>(item.tolerance.corner_mm);
    piece.tolerance.weld = static_cast<double>(item.tolerance.weld_mm);
    piece.continues = item.continues;
    pass_on(piece);
    stops_ = false;
  }
}

void BesideWay::pass_on(const PathPiece& piece) {
  sink_(piece);
  last_end_ = piece.curve.end();
}

ProgrammedPath beside_path(ProgrammedPath programmed) {
  const bool any = std::ranges::any_of(
      programmed.pieces, [](const PathPiece& piece) { return piece.beside.has_value(); });
  if (!any) return programmed;
  ProgrammedPath path = programmed;
  path.pieces.clear();
  BesideWay way{[&path](const PathPiece& piece) { path.pieces.push_back(piece); }};
  for (const PathPiece& piece : programmed.pieces) way.put(piece);
  way.end();
  if (!path.pieces.empty()) path.end = path.pieces.back().curve.end();
  return path;
}

}  // namespace sim
