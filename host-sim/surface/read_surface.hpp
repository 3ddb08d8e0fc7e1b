#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "host-sim/surface/mesh.hpp"
#include "host-sim/surface/point_grid.hpp"

namespace sim::surface {

/// A measured surface as a file describes it.
struct SurfaceInput {
  /// The grid where the file has one. +Z sees its columns turn counter-clockwise to its rows;
  /// a file with the other order of rows is reversed.
  std::optional<PointGrid> grid;
  Mesh mesh;                       ///< Always; of a grid, triangulated() of it.
  std::vector<std::string> notes;  ///< What was changed or passed over, for the operator.
};

struct ReadOptions {
  double unit_mm = 1.0;   ///< Length of the file's unit; above 0.
  double pitch_mm = 0.0;  ///< Distance of a height map's neighbours; 0: as the file says.
  /// Height of a picture's white, or of a map's greatest over its least value; 0: as the file says.
  double height_mm = 0.0;
  bool repair = false;  ///< Fill missing points and outliers from their neighbours.
};

/// Coordinates farther from the origin are refused: they are a slip of units.
inline constexpr double kFarthestMm = 1.0e4;
/// Points of a grid or a mesh, at most; 24 bytes each.
inline constexpr std::size_t kMaxPoints = 40'000'000;

/// Reads a surface in one of these formats, told by content; `name` is for messages.
///
/// - XYZ text or CSV in rows, which blank lines or the turn of the scan separate;
/// - STL, binary and ASCII, whose equal corners become one point;
/// - PLY, ASCII and binary of both byte orders, with polygons as fans, or strips;
/// - height maps: ESRI ASCII grid, GeoTIFF, grey TIFF, PGM and PNG of 8 and 16 bit, and JSON of
///   width, height and values. Their first row has the greatest Y.
///
/// Throws std::invalid_argument with the place, the reason and a remedy; rows, columns and facets
/// are counted from 1 as in the file. Outliers of pictures are drawn ones and are kept.
[[nodiscard]] SurfaceInput read_surface(std::string_view bytes,
                                        const std::string& name,
                                        const ReadOptions& options);

}  // namespace sim::surface
