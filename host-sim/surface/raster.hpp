#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "host-sim/surface/grid_draft.hpp"
#include "host-sim/surface/read_surface.hpp"

namespace sim::surface {

/// Heights over a regular grid in the order of a file. The first row has the highest Y.
struct Raster {
  std::size_t rows = 0;
  std::size_t columns = 0;
  Eigen::Vector2d origin{0.0, 0.0};  ///< X and Y of the first point of the last row, mm.
  Eigen::Vector2d pitch{0.0, 0.0};   ///< Distance between columns and between rows, mm.
  std::vector<double> heights{};     ///< Heights row by row, mm; NaN if a height is missing.
  std::vector<std::uint32_t> lines{};
};

/// Returns the points of a raster, row by row in the raster's order.
[[nodiscard]] GridDraft draft_of(Raster raster, const std::string& name);

/// Throws std::invalid_argument for fewer than two rows or columns, or more than kMaxPoints points.
void require_raster_size(std::uint64_t rows, std::uint64_t columns, const std::string& name);

/// Throws std::invalid_argument if the options give no pitch. Called for formats that do not
/// contain a pitch.
void require_pitch(const ReadOptions& options, const std::string& name);

/// Converts the grey values of a picture to heights. `white` is the grey value of white. Throws
/// std::invalid_argument if the options give no pitch or no height.
[[nodiscard]] GridDraft picture_draft(Raster grey,
                                      double white,
                                      const std::string& name,
                                      const ReadOptions& options);

}  // namespace sim::surface
