#pragma once

#include <string>
#include <string_view>

#include "host-sim/surface/grid_draft.hpp"
#include "host-sim/surface/read_surface.hpp"

namespace sim::surface {

/// Returns whether the bytes begin with the signature of a TIFF or BigTIFF file, in either byte
/// order.
[[nodiscard]] bool is_tiff(std::string_view bytes);

/// Reads the first image of a TIFF file with one sample for each pixel. Heights of a GeoTIFF and
/// real numbers have the unit in the options. The file's GDAL_NODATA value and NaN are missing
/// points. Whole numbers without a scale are the grey values of a picture. The pitch comes from the
/// options or the GeoTIFF. The first point of the last row is at 0, 0, because the coordinates of a
/// map are far beyond a machine's travel. Throws std::invalid_argument.
/// @pre is_tiff(bytes)
[[nodiscard]] GridDraft read_tiff(std::string_view bytes,
                                  const std::string& name,
                                  const ReadOptions& options);

}  // namespace sim::surface
