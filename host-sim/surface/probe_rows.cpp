#include "host-sim/surface/probe_rows.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <iterator>

namespace sim::surface {

std::string text_of_probe_rows(const ProbeGrid& grid,
                               const std::vector<Eigen::Vector3d>& points,
                               const std::vector<std::string>& heading) {
  fmt::memory_buffer text;
  const auto out = std::back_inserter(text);
  for (const std::string& line : heading) fmt::format_to(out, "# {}\n", line);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (i > 0 && i % grid.x.count == 0) text.push_back('\n');
    const Eigen::Vector3d& point = points[i];
    fmt::format_to(out, "{:.6f} {:.6f} {:.6f}\n", point.x(), point.y(), point.z());
  }
  return fmt::to_string(text);
}

}  // namespace sim::surface
