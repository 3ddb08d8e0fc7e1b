#pragma once

#include <string>
#include <string_view>

#include "host-sim/surface/grid_draft.hpp"
#include "host-sim/surface/read_surface.hpp"

namespace sim::surface {

/// Returns whether bytes begin as a TIFF or a BigTIFF file does, of either order of bytes.
[[nodiscard]] bool is_tiff(std::string_view bytes);

/// Reads the first image of a TIFF file, of one sample a pixel. Heights of a GeoTIFF and of real
/// numbers are in units of the file, and its GDAL_NODATA and NaN are missing points; whole numbers
/// without a scale are the grey of a picture. The pitch is the options' or the GeoTIFF's. The first
/// point of the last row is at 0, 0, as the coordinates of a map are far from any machine. Throws
/// std::invalid_argument.
/// @pre is_tiff(bytes)
[[nodiscard]] GridDraft read_tiff(std::string_view bytes,
                                  const std::string& name,
                                  const ReadOptions& options);

}  // namespace sim::surface
