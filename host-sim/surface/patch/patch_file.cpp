#include "host-sim/surface/patch/patch_file.hpp"

#include <fmt/format.h>

#include <iterator>

namespace sim::surface::patch {

std::string patch_text(const PatchSurface& surface) {
  std::string text;
  std::size_t number = 0;
  for (const GridPatch& patch : surface.patches) {
    // Without a precision, fmt writes the shortest text that is read back as the same number.
    fmt::format_to(std::back_inserter(text),
                   "patch {} {} {} {} {}\n",
                   number++,
                   patch.u.from,
                   patch.u.to,
                   patch.v.from,
                   patch.v.to);
    for (const BezierCurve& row : patch.shape.rows) {
      for (const Eigen::Vector3d& point : row.controls) {
        fmt::format_to(
            std::back_inserter(text), "{:.17g} {:.17g} {:.17g}\n", point.x(), point.y(), point.z());
      }
    }
  }
  return text;
}

}  // namespace sim::surface::patch
