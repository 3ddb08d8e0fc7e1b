#pragma once

#include <cstdint>

#include "host-sim/contour/contour_offset.hpp"
#include "host-sim/pocket/path_rows.hpp"

namespace sim::pocket {

/// Path of one level by the method of paper 5 (Oh and Kwon 2003).
struct PaperPath : PathRows {
  std::uint32_t loops = 0;
};

/// Makes the path of cnc::pocket::write_paper_path() down to one depth, with storage that is large
/// enough. The tool plunges at the beginning of the innermost loop. Throws NoPocketPath if the
/// paper's method does not support the pocket.
[[nodiscard]] PaperPath paper_path(const cnc::contour::ContourView<double>& pocket,
                                   double tool_radius_mm,
                                   double depth_mm);

}  // namespace sim::pocket
