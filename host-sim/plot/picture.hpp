#pragma once

#include <string>

#include "host-sim/plot/path.hpp"

namespace sim {

struct PictureOptions {
  std::string title;           ///< Usually the name of the job; may be empty.
  double kerf_width_mm = 0.1;  ///< Drawn where the beam is on; 0 draws the hairline only.
  /// Of the job, as its report has it; below 0 it is measured on the path.
  double cut_length_mm = -1.0;
};

inline constexpr double kPictureWidthPx = 1600.0;

/// The picture of a job as an SVG document (`--svg FILE`): the XY view of the
/// path as cut, coloured by speed, depth or power, rapids dashed, with grid, legend, scale bar,
/// start and end marks, dimensions and time. A job without motion in X and Y is
/// a valid picture that says so. Below 2 MB for any path of PathRecorder.
[[nodiscard]] std::string draw_svg(const Path& path, const PictureOptions& options);

/// Throws std::system_error naming the file.
void write_svg(const std::string& file, const Path& path, const PictureOptions& options);

}  // namespace sim
