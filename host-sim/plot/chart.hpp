#pragma once

#include <string>
#include <vector>

namespace sim {

struct ChartPoint {
  double x = 0.0;
  double y = 0.0;
};

/// One series of a chart: a line, dots in the same colour, and a band around the line.
struct ChartSeries {
  std::string label;
  std::vector<ChartPoint> line{};
  std::vector<ChartPoint> dots{};
  /// Half of the width of the band at each point of the line; empty for no band.
  std::vector<double> half_bands{};
};

/// A panel of a chart: two axes and the series drawn between them. Both axes begin and end at round
/// numbers, and include all data.
struct ChartPanel {
  std::string x_label;
  std::string y_label;
  std::vector<ChartSeries> series{};
};

/// Returns an SVG document with a width of 1600 px, in which the panels are next to each other. A
/// panel without points has a text that states this fact.
/// @pre there is at least one panel
[[nodiscard]] std::string draw_chart(const std::string& title,
                                     const std::string& subtitle,
                                     const std::vector<ChartPanel>& panels);

}  // namespace sim
