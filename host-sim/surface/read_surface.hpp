#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "host-sim/surface/mesh.hpp"
#include "host-sim/surface/point_grid.hpp"

namespace sim::surface {

/// A measured surface, as read from a file.
struct SurfaceInput {
  /// The grid, if the file has one. Seen from +Z, the direction of rising row numbers is
  /// counter-clockwise from the direction of rising column numbers. The rows of a file are reversed
  /// if necessary.
  std::optional<PointGrid> grid;
  Mesh mesh;  ///< Mesh of the surface. For a grid, it is triangulated(grid).
  /// Messages for the operator about changed or ignored data.
  std::vector<std::string> notes;
};

struct ReadOptions {
  double unit_mm = 1.0;   ///< Length of the file's unit in mm, above 0.
  double pitch_mm = 0.0;  ///< Distance between neighbours of a height map, mm; 0: as in the file.
  /// Height of white in a picture, mm; for a height map, height of the greatest value above the
  /// least value; 0: as in the file.
  double height_mm = 0.0;
  bool repair = false;  ///< Whether to fill missing points and outliers from their neighbours.
};

/// Maximum distance of coordinates from the origin. Larger coordinates are refused, because they
/// indicate a wrong unit.
inline constexpr double kFarthestMm = 1.0e4;
/// Maximum number of points of a grid or a mesh; each takes 24 bytes.
inline constexpr std::size_t kMaxPoints = 40'000'000;

/// Reads a surface in one of the following formats, which are recognized by content. `name` is the
/// file's name for messages.
///
/// - XYZ text or CSV in rows, which are separated by blank lines or by reversals of the scan;
/// - STL, binary and ASCII, whose equal corners become one point;
/// - PLY, ASCII and binary of both byte orders, with polygons as fans, or strips;
/// - height maps: ESRI ASCII grid, GeoTIFF, grey TIFF, PGM and PNG of 8 and 16 bit, and JSON of
///   width, height and values. Their first row has the greatest Y.
///
/// Throws std::invalid_argument with the position in the file, the reason and a remedy. Rows,
/// columns and facets are counted from 1 as in the file. Outliers of pictures are part of the
/// drawing and are kept.
[[nodiscard]] SurfaceInput read_surface(std::string_view bytes,
                                        const std::string& name,
                                        const ReadOptions& options);

}  // namespace sim::surface
