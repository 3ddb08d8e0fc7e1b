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

  void end() {
    if (!compensator_->active()) return;
    if (!refused_ && !compensator_->end()) take();
    compensator_->clear();
    refused_ = false;
  }

 private:
  /// The first piece after G40 begins beside the path, as the rest does not.
  void leave(const PathPiece& piece) {
    const bool exit = compensator_->active();
    end();
    path_.pieces.push_back(piece);
    if (!exit || path_.pieces.size() < 2) return;
    path_.pieces.back().curve =
        Curve::line(path_.pieces[path_.pieces.size() - 2].curve.end(), piece.curve.end());
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
