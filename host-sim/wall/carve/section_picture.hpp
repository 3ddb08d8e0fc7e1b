#pragma once

#include <string>
#include <vector>

#include "host-sim/surface/mesh.hpp"
#include "host-sim/wall/carve/columns.hpp"
#include "host-sim/wall/carve/section.hpp"

namespace sim::wall {

/// A carved block, and a line of text that is written below the picture of its section.
struct CarvedSection {
  const Columns* columns = nullptr;  ///< Columns of the block; never null.
  std::string caption;
};

/// Returns the sections of carved blocks along one line, one below the other, as an SVG document.
/// The remaining material is grey, and the drawn part is red. Scales show distances along the line
/// and heights in mm.
/// @pre the line has a length
[[nodiscard]] std::string draw_sections(const std::string& title,
                                        const std::vector<CarvedSection>& sections,
                                        const surface::Mesh& part,
                                        const SectionLine& line);

}  // namespace sim::wall
