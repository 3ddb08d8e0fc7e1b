#include "host-sim/cut/open_lines.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>

namespace sim::cut {
namespace {

using drawing::DrawnContour;

/// The open contours of one layer that are changed to cuts on the line.
struct LayerLines {
  std::size_t count = 0;
  std::size_t first = 0;  ///< Number of the first changed contour.
};

drawing::Fault told(const drawing::Drawing& drawn, std::size_t layer, const LayerLines& lines) {
  const DrawnContour& first = drawn.contours[lines.first];
  return {drawing::FaultKind::kOpen,
          first.entity,
          start_of(first.shapes.front()),
          fmt::format("{} open contour{} of layer \"{}\" {}, this one first, {} cut on the line",
                      lines.count,
                      lines.count == 1 ? "" : "s",
                      drawn.layers[layer].name,
                      drawn.layers[layer].colour,
                      lines.count == 1 ? "is" : "are"),
          "close contours that are edges of parts: the cut goes half a kerf into them"};
}

}  // namespace

std::vector<drawing::Fault> cut_open_on_line(const drawing::Drawing& drawn,
                                             const std::vector<LayerPlan>& layers,
                                             Recipes& recipes) {
  std::map<std::size_t, LayerLines> lines;
  // Number of the new plan, by the layer and the number of the old plan of a contour.
  std::map<std::pair<std::size_t, std::uint32_t>, std::uint32_t> plans;
  for (std::size_t i = 0; i < drawn.contours.size(); ++i) {
    const DrawnContour& contour = drawn.contours[i];
    const std::size_t layer = contour.entity.layer;
    const LayerPlan plan = recipes.of(i, layers[layer]);
    if (contour.closed || contour.is_doubtful || plan.settings.side != Side::kWaste) continue;
    recipes.by_contour.resize(drawn.contours.size(), Recipes::kOfLayer);
    std::uint32_t& of_contour = recipes.by_contour[i];
    const auto [known, is_new] =
        plans.try_emplace({layer, of_contour}, static_cast<std::uint32_t>(recipes.plans.size()));
    if (is_new) {
      recipes.plans.push_back(plan);
      recipes.plans.back().settings.side = Side::kOn;
    }
    of_contour = known->second;
    LayerLines& of_layer = lines[layer];
    if (of_layer.count++ == 0) of_layer.first = i;
  }
  std::vector<drawing::Fault> warnings;
  warnings.reserve(lines.size());
  for (const auto& [layer, of_layer] : lines) warnings.push_back(told(drawn, layer, of_layer));
  return warnings;
}

}  // namespace sim::cut
