#include "host-sim/measure/driven_path.hpp"

#include <memory>

#include "host-sim/measure/path_items.hpp"
#include "planner/path/path_stage.hpp"

namespace sim {

ReadOptions read_options_for(const cnc::Settings& settings) {
  return {.laser_mode = settings.get(cnc::setting::kLaserMode) != 0.0F,
          .stop_at_coolant = true,
          .path_tolerance = settings.get(cnc::setting::kJunctionDeviation),
          .arc_tolerance = settings.get(cnc::setting::kArcTolerance),
          .power_keeps_kerf = settings.get(cnc::setting::kKerfControl) == 0.0F,
          .block_delete = settings.get(cnc::setting::kBlockDelete) != 0.0F};
}

ProgrammedPath driven_path(const ProgrammedPath& programmed, const cnc::motion::Limits& limits) {
  const auto stage = std::make_unique<cnc::path::PathStage>(limits);
  ProgrammedPath driven;
  const auto take = [&] {
    while (const cnc::path::PathPiece* const piece = stage->next()) {
      const bool stop = piece->joint == cnc::motion::Joint::kStop;
      const auto& request = piece->request;
      driven.pieces.push_back(piece_of(request.element, request.feed_mm_s, stop));
      set_beam(driven.pieces.back(), request.beam);
    }
  };
  const auto take_all = [&] {
    while (!stage->empty()) {
      stage->flush();
      take();
    }
  };
  for (const PathPiece& piece : programmed.pieces) {
    if (piece.stop_before) take_all();
    const cnc::path::PathItem item = item_of(piece);
    if (item.request.element.start == item.request.element.end) continue;
    while (!stage->has_room()) take();
    stage->put(item);
    take();
  }
  take_all();
  driven.start = programmed.start;
  driven.end = programmed.end;
  return driven;
}

}  // namespace sim
