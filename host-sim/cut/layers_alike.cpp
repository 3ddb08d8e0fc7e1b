#include "host-sim/cut/layers_alike.hpp"

#include "host-sim/import/fill_across.hpp"

namespace sim::cut {
namespace {

bool are_alike(const LayerPlan& a, const LayerPlan& b) {
  return a.settings == b.settings && a.condition.kerf_mm == b.condition.kerf_mm &&
         a.condition.cut.power_mw == b.condition.cut.power_mw &&
         a.condition.cut.speed_um_min == b.condition.cut.speed_um_min;
}

}  // namespace

std::vector<std::size_t> layers_alike(const std::vector<LayerPlan>& layers) {
  std::vector<std::size_t> groups(layers.size(), drawing::kAloneInGroup);
  std::vector<std::size_t> firsts;  // Number of the first layer of each group.
  for (std::size_t layer = 0; layer < layers.size(); ++layer) {
    if (layers[layer].settings.side != Side::kWaste) continue;
    for (const std::size_t first : firsts) {
      if (are_alike(layers[first], layers[layer])) groups[layer] = first;
    }
    if (groups[layer] != drawing::kAloneInGroup) continue;
    groups[layer] = layer;
    firsts.push_back(layer);
  }
  return groups;
}

}  // namespace sim::cut
