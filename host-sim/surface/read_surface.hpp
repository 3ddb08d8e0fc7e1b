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
  /// counter-clockwise from that of rising column numbers; a file with the other order of rows is
  /// reversed.
  std::optional<PointGrid> grid;
  Mesh mesh;  ///< The mesh of every input; for a grid, triangulated() of it.
  /// Messages for the operator on data that was changed or ignored.
  std::vector<std::string> notes;
};

struct ReadOptions {
  double unit_mm = 1.0;   ///< Length of the file's unit in mm, above 0.
  double pitch_mm = 0.0;  ///< Distance between neighbours of a height map; 0: as in the file.
  /// Height of white in a picture; for a map, height of its greatest value above its least; 0: as
  /// in the file.
  double height_mm = 0.0;
  bool repair = false;  ///< Whether to fill missing points and outliers from their neighbours.
};

/// Maximum distance of coordinates from the origin. Larger coordinates are refused, because they
/// come from a wrong unit.
inline constexpr double kFarthestMm = 1.0e4;
/// Maximum number of points of a grid or a mesh; each takes 24 bytes.
inline constexpr std::size_t kMaxPoints = 40'000'000;

/// Reads a surface in one of these formats, which it recognizes by content. `name` is for messages.
///
/// - XYZ text or CSV in rows, which are separated by blank lines or by the turns of the scan;
/// - STL, binary and ASCII, whose equal corners become one point;
/// - PLY, ASCII and binary of both byte orders, with polygons as fans, or strips;
/// - height maps: ESRI ASCII grid, GeoTIFF, grey TIFF, PGM and PNG of 8 and 16 bit, and JSON of
///   width, height and values. Their first row has the greatest Y.
///
/// Throws std::invalid_argument with the place, the reason and a remedy. Rows, columns and facets
/// are counted from 1 as in the file. Outliers of pictures are part of the drawing and are kept.
[[nodiscard]] SurfaceInput read_surface(std::string_view bytes,
                                        const std::string& name,
                                        const ReadOptions& options);

}  // namespace sim::surface
