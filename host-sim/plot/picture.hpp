#pragma once

#include <string>

#include "host-sim/plot/path.hpp"

namespace sim {

struct PictureOptions {
  std::string title;           ///< Usually the name of the job; may be empty.
  double kerf_width_mm = 0.1;  ///< Width of the kerf, where the beam is on; 0: only a hairline.
  /// Length of the cuts as in the job's report. A value below 0 means that the length is measured
  /// on the path.
  double cut_length_mm = -1.0;
};

inline constexpr double kPictureWidthPx = 1600.0;

/// Returns the picture of a job as an SVG document (`--svg FILE`): the XY view of the path as it
/// was cut, coloured by speed, depth or power, with rapids dashed. It has a grid, legend, scale
/// bar, start and end marks, dimensions and time. A job without motion in X and Y gives a valid
/// picture that says so. The document is below 2 MB for any path of PathRecorder.
[[nodiscard]] std::string draw_svg(const Path& path, const PictureOptions& options);

/// Writes the picture of a job. Throws std::system_error naming the file.
void write_svg(const std::string& file, const Path& path, const PictureOptions& options);

}  // namespace sim
