#pragma once

#include <string>
#include <vector>

namespace sim {

struct ChartPoint {
  double x = 0.0;
  double y = 0.0;
};

/// One line of a chart, and dots in its colour.
struct ChartSeries {
  std::string label;
  std::vector<ChartPoint> line{};
  std::vector<ChartPoint> dots{};
  std::vector<double> half_bands{};  ///< Half of the band's width at each point of the line.
};

/// A pair of axes with its lines. Both axes begin and end at round numbers that enclose the data.
struct ChartPanel {
  std::string x_label;
  std::string y_label;
  std::vector<ChartSeries> series{};
};

/// Returns an SVG document of 1600 px width with the panels next to each other. A panel without
/// points has a text that says so.
/// @pre there is at least one panel
[[nodiscard]] std::string draw_chart(const std::string& title,
                                     const std::string& subtitle,
                                     const std::vector<ChartPanel>& panels);

}  // namespace sim
