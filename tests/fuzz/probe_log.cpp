/// libFuzzer: any bytes as a sender's log with answers of a probe, and as a probing program.

#include "host-sim/surface/probe_log.hpp"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <string_view>

#include "host-sim/surface/probe_program.hpp"
#include "host-sim/surface/probe_tip.hpp"
#include "host-sim/surface/probed_points.hpp"

namespace {

using sim::surface::ProbePlan;

void require_probed(bool holds, const char* rule) {
  if (holds) return;
  std::fprintf(stderr, "violated: %s\n", rule);
  std::abort();
}

void judge_log(std::string_view bytes, std::size_t touches) {
  ProbePlan plan{.grid = {.x = {.from_mm = 0.0, .to_mm = 4.0, .count = 3},
                          .y = {.from_mm = 0.0, .to_mm = 2.0, .count = 3}},
                 .depth_mm = -5.0,
                 .touches = touches,
                 .has_guards = touches > 1};
  const auto log = sim::surface::read_probe_log(bytes);
  if (log.offset) plan.offset = *log.offset;
  const auto probed = sim::surface::probed_points(log, plan, "fuzz");
  const auto points = sim::surface::touched_points(plan.grid, probed.points, 2.0);
  require_probed(points.size() == plan.grid.size(), "each point has a place");
  std::size_t lacking = 0;
  for (const Eigen::Vector3d& point : points) {
    require_probed(point.head<2>().allFinite() && !std::isinf(point.z()), "places are finite");
    if (std::isnan(point.z())) ++lacking;
  }
  require_probed(lacking == probed.faults.size(), "a fault for each point that lacks");
}

template <typename Reader>
void read_or_refuse(const Reader& read) {
  try {
    read();
  } catch (const std::invalid_argument& error) {
    const std::string_view text{error.what()};
    require_probed(text.starts_with("fuzz:"), "a refusal names the file");
    require_probed(text.find("; ") != std::string_view::npos, "and a remedy");
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes{reinterpret_cast<const char*>(data), size};
  read_or_refuse([&] { judge_log(bytes, 1); });
  read_or_refuse([&] { judge_log(bytes, 2); });
  read_or_refuse([&] { static_cast<void>(sim::surface::read_probe_heading(bytes, "fuzz")); });
  return 0;
}
