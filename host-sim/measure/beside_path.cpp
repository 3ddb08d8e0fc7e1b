#include "host-sim/measure/beside_path.hpp"

#include <algorithm>
#include <memory>

#include "host-sim/measure/path_items.hpp"
#include "planner/compensation/compensator.hpp"

namespace sim {
namespace {

/// Passes the pieces of a path on, those between G41 or G42 and G40 through the compensator.
class BesideWay {
 public:
  explicit BesideWay(ProgrammedPath& path) : path_{path} {}

  void put(const PathPiece& piece) {
    if (!piece.beside) return leave(piece);
    const cnc::path::PathItem item = item_of(piece);
    if (!compensator_->active()) {
      // The entry moves in the plane; other axes may be moved before.
      if (!cnc::compensation::moves_in(piece.beside->plane, item.request.element)) {
        return path_.pieces.push_back(piece);
      }
      compensator_->begin(item.request.element.start,
                          piece.beside->plane,
                          static_cast<float>(piece.beside->offset_mm));
      stops_ = piece.stop_before;
    }
    if (refused_) return;
    refuse(compensator_->put(item), piece.line);
    take();
  }

  void end() {
    if (!compensator_->active()) return;
    if (!refused_) {
      refuse(compensator_->end(), 0);
      take();
    }
    if (refused_) compensator_->clear();
    refused_ = false;
  }

 private:
  /// The first piece after G40 that moves in the plane leads back from beside the path. Pieces
  /// before it move other axes beside the path.
  void leave(const PathPiece& piece) {
    const bool follows = compensator_->active() || compensator_->beside();
    end();
    const bool nowhere = piece.curve.length() <= 0.0;
    if (!follows || path_.pieces.empty()) {
      if (!nowhere) path_.pieces.push_back(piece);
      return;
    }
    const Point here = path_.pieces.back().curve.end();
    Point to = piece.curve.end();
    const cnc::path::PathItem item = item_of(piece);
    const bool leads_back =
        nowhere || cnc::compensation::moves_in(compensator_->plane(), item.request.element);
    if (compensator_->beside() && leads_back) {
      refuse(compensator_->leave(item.request.element.end, piece.travel == Travel::kRapid),
             piece.line);
      take();
      refused_ = false;
      compensator_->clear();
    } else if (compensator_->beside()) {
      const cnc::PlaneAxes axes = cnc::axes_of(compensator_->plane());
      to[axes.first] = here[axes.first];
      to[axes.second] = here[axes.second];
      compensator_->stand_at(item.request.element.end);
    }
    const Point from = path_.pieces.back().curve.end();
    path_.pieces.push_back(piece);
    path_.pieces.back().curve = Curve::line(from, to);
  }

  /// @param line of the piece that is refused, where the fault has none
  void refuse(const std::optional<cnc::compensation::Fault>& fault, int line) {
    if (!fault) return;
    refused_ = true;
    if (path_.refused) return;
    const bool other = fault->other_line != fault->line;
    path_.refused = {fault->line != 0 ? static_cast<int>(fault->line) : line,
                     other ? static_cast<int>(fault->other_line) : 0};
  }

  void take() {
    cnc::path::PathItem item;
    while (!refused_ && compensator_->take(item)) {
      PathPiece piece = piece_of(item.request.element, item.request.feed_mm_s, stops_);
      set_beam(piece, item.request.beam);
      piece.line = static_cast<int>(item.request.line.number);
      piece.tolerance.corner = static_cast<double>(item.tolerance.corner_mm);
      piece.tolerance.weld = static_cast<double>(item.tolerance.weld_mm);
      piece.continues = item.continues;
      path_.pieces.push_back(piece);
      stops_ = false;
    }
  }

  ProgrammedPath& path_;
  std::unique_ptr<cnc::compensation::Compensator> compensator_ =
      std::make_unique<cnc::compensation::Compensator>();
  bool stops_ = false;
  bool refused_ = false;
};

}  // namespace

ProgrammedPath beside_path(ProgrammedPath programmed) {
  const bool any = std::ranges::any_of(
      programmed.pieces, [](const PathPiece& piece) { return piece.beside.has_value(); });
  if (!any) return programmed;
  ProgrammedPath path = programmed;
  path.pieces.clear();
  BesideWay way{path};
  for (const PathPiece& piece : programmed.pieces) way.put(piece);
  way.end();
  if (!path.pieces.empty()) path.end = path.pieces.back().curve.end();
  return path;
}

}  // namespace sim
