#pragma once

#include <string>

#include "host-sim/plot/path.hpp"

namespace sim {

struct PictureOptions {
  std::string title;  ///< Title, usually the name of the job; may be empty.
  /// Width of the kerf that is drawn where the beam is on. 0 for no kerf.
  double kerf_width_mm = 0.1;
  /// Length of the cuts, as in the report of the job. If it is below 0, the length is measured
  /// along the path.
  double cut_length_mm = -1.0;
};

inline constexpr double kPictureWidthPx = 1600.0;

/// Returns the picture of a job as an SVG document (`--svg FILE`): the XY view of the path as it
/// was cut, coloured by speed, depth or power, with rapids dashed. It contains a grid, a legend, a
/// scale bar, marks of start and end, dimensions and time. The picture of a job without motion in X
/// and Y contains a text that states this fact. The document has less than 2 MB for any path of
/// PathRecorder.
[[nodiscard]] std::string draw_svg(const Path& path, const PictureOptions& options);

/// Writes the picture of a job. Throws std::system_error, with the name of the file, if it cannot
/// be written.
void write_svg(const std::string& file, const Path& path, const PictureOptions& options);

}  // namespace sim
