#include "host-sim/surface/raster.hpp"

#include <fmt/format.h>

#include <utility>

#include "host-sim/surface/refusal.hpp"

namespace sim::surface {

GridDraft draft_of(Raster raster, const std::string& name) {
  GridDraft grid{.name = name, .rows = raster.rows, .columns = raster.columns};
  grid.points.reserve(raster.heights.size());
  for (std::size_t row = 0; row < raster.rows; ++row) {
    const double y =
        raster.origin.y() + static_cast<double>(raster.rows - 1 - row) * raster.pitch.y();
    for (std::size_t column = 0; column < raster.columns; ++column) {
      const double x = raster.origin.x() + static_cast<double>(column) * raster.pitch.x();
      grid.points.emplace_back(x, y, raster.heights[row * raster.columns + column]);
    }
  }
  grid.lines = std::move(raster.lines);
  return grid;
}

void require_raster_size(std::uint64_t rows, std::uint64_t columns, const std::string& name) {
  if (rows < 2 || columns < 2) {
    refuse(name,
           0,
           fmt::format("has {} rows of {} heights", rows, columns),
           "a surface has at least two rows of two heights");
  }
  if (rows > kMaxPoints || columns > kMaxPoints / rows) {
    refuse(name,
           0,
           fmt::format("{} rows of {} heights are too many", rows, columns),
           fmt::format("thin it out to {} points", kMaxPoints));
  }
}

void require_pitch(const ReadOptions& options, const std::string& name) {
  if (options.pitch_mm > 0.0) return;
  refuse(name, 0, "the distance between its heights is unknown", "give it in mm with --pitch");
}

GridDraft picture_draft(Raster grey,
                        double white,
                        const std::string& name,
                        const ReadOptions& options) {
  require_pitch(options, name);
  if (options.height_mm <= 0.0) {
    refuse(name, 0, "the height of its white is unknown", "give it in mm with --height");
  }
  grey.pitch = {options.pitch_mm, options.pitch_mm};
  for (double& height : grey.heights) height *= options.height_mm / white;
  GridDraft draft = draft_of(std::move(grey), name);
  draft.is_picture = true;
  return draft;
}

}  // namespace sim::surface
