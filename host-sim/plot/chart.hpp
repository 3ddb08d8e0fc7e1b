#pragma once

#include <string>
#include <vector>

namespace sim {

struct ChartPoint {
  double x = 0.0;
  double y = 0.0;
};

/// One line of a chart, and dots of its colour.
struct ChartSeries {
  std::string label;
  std::vector<ChartPoint> line{};
  std::vector<ChartPoint> dots{};
  std::vector<double> half_bands{};  ///< How far the band reaches around each point of the line.
};

/// One pair of axes. Both begin and end at round numbers around what is shown.
struct ChartPanel {
  std::string x_label;
  std::string y_label;
  std::vector<ChartSeries> series{};
};

/// Panels side by side as an SVG document, 1600 px wide. A panel without points says so.
/// @pre at least one panel
[[nodiscard]] std::string draw_chart(const std::string& title,
                                     const std::string& subtitle,
                                     const std::vector<ChartPanel>& panels);

}  // namespace sim
