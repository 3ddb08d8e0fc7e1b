#include "host-sim/measure/beside_path.hpp"

#include <algorithm>

#include "host-sim/measure/path_items.hpp"

namespace sim {

void BesideWay::put(const PathPiece& piece) {
  if (!piece.beside) return leave(piece);
  const cnc::path::PathItem item = item_of(piece);
  if (!compensator_->active()) {
    // The entry moves in the plane of the offset. Before the entry, only other axes may move.
    if (!cnc::compensation::moves_in(piece.beside->plane, item.request.element)) {
      return pass_on(piece);
    }
    compensator_->begin(item.request.element.start,
                        piece.beside->plane,
                        static_cast<float>(piece.beside->offset_mm));
    stops_ = piece.stop_before;
  }
  if (drops_) return;
  refuse(compensator_->put(item), piece.line);
  take();
}

void BesideWay::end() {
  if (!compensator_->active()) return;
  if (!drops_) {
    refuse(compensator_->end(), 0);
    take();
  }
  if (drops_) compensator_->clear();
  drops_ = false;
}

/// Ends the compensation. The first piece after G40 that moves in the plane leads back to the
/// programmed path. Pieces before it move only other axes and stay offset.
void BesideWay::leave(const PathPiece& piece) {
  const bool follows = compensator_->active() || compensator_->beside();
  end();
  const bool nowhere = piece.curve.length() <= 0.0;
  if (!follows || !last_end_) {
    if (!nowhere) pass_on(piece);
    return;
  }
  Point to = piece.curve.end();
  if (compensator_->beside()) {
    const cnc::PathElement element = item_of(piece).request.element;
    if (nowhere || cnc::compensation::moves_in(compensator_->plane(), element)) {
      go_back(piece, element.end);
    } else {
      const cnc::PlaneAxes axes = cnc::axes_of(compensator_->plane());
      to[axes.first] = (*last_end_)[axes.first];
      to[axes.second] = (*last_end_)[axes.second];
      compensator_->stand_at(element.end);
    }
  }
  PathPiece way_back = piece;
  way_back.curve = Curve::line(*last_end_, to);
  pass_on(way_back);
}

/// Passes on the arc about the corner at which the exit `piece` begins, if there is such an arc.
void BesideWay::go_back(const PathPiece& piece, const cnc::Position& to) {
  refuse(compensator_->leave(to, piece.travel == Travel::kRapid), piece.line);
  take();
  drops_ = false;
  compensator_->clear();
}

/// Records a refusal if there is a fault.
/// @param line line of the refused piece, for a fault without a line number
void BesideWay::refuse(const std::optional<cnc::compensation::Fault>& fault, int line) {
  if (!fault) return;
  drops_ = true;
  if (refused_) return;
  const bool other = fault->other_line != fault->line;
  refused_ = {fault->line != 0 ? static_cast<int>(fault->line) : line,
              other ? static_cast<int>(fault->other_line) : 0};
}

void BesideWay::take() {
  cnc::path::PathItem item;
  while (!drops_ && compensator_->take(item)) {
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
  path.refused = way.refused();
  if (!path.pieces.empty()) path.end = path.pieces.back().curve.end();
  return path;
}

}  // namespace sim
