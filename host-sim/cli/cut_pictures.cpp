#include "host-sim/cli/cut_pictures.hpp"

#include <algorithm>
#include <set>
#include <stdexcept>
#include <string>

#include "host-sim/cli/cut_offered.hpp"
#include "host-sim/cli/picture_files.hpp"
#include "host-sim/trace/input_file.hpp"

namespace sim {

using drawing::FaultKind;

void keep_burnt_pictures(const CutCommandOptions& options,
                         const std::vector<cut::LayerRule>& rules,
                         drawing::Drawing& drawn,
                         InputFiles& inputs) {
  if (drawn.pictures.empty()) return;
  std::vector<cut::LayerSettings> layers;
  layers.reserve(drawn.layers.size());
  for (const drawing::Layer& layer : drawn.layers) {
    layers.push_back(settings_of_layer(options, layer, rules));
  }
  cut::keep_burnt_pictures(drawn, layers);
  for (const drawing::DrawnPicture& picture : drawn.pictures) {
    if (picture.file.empty()) continue;
    const std::string file = file_beside(options.file, picture.file);
    inputs.add("picture", file, read_bytes(file));
  }
}

std::vector<cut::Cut> picture_cuts_of(const CutCommandOptions& options,
                                      const drawing::Drawing& drawn,
                                      const std::vector<cut::LayerPlan>& layers,
                                      const cut::Beam& beam,
                                      const cut::OrderWish& machine,
                                      std::vector<drawing::Fault>& warnings) {
  const cut::PictureForm form{.is_plain = options.post.is_asked(), .decimals = options.decimals};
  return cut::picture_cuts(drawn, layers, beam, form, machine, warnings);
}

cut::Condition picture_condition(const cut::LayerSettings& settings, std::uint32_t thickness_um) {
  if (!settings.power_w || !settings.feed_mm_min) {
    throw std::invalid_argument(
        "a picture requires its own power and feed, such as power=20%, feed=3000");
  }
  return {{thickness_um, power_option(*settings.power_w), speed_option(*settings.feed_mm_min)}};
}

std::vector<drawing::Fault> picture_faults(const drawing::Drawing& drawn,
                                           const std::vector<cut::LayerPlan>& layers) {
  const auto is_burnt = [&layers](std::size_t layer) {
    return layer < layers.size() && layers[layer].settings.side == cut::Side::kImage;
  };
  std::vector<drawing::Fault> faults;
  std::set<std::size_t> told;
  for (const drawing::DrawnContour& contour : drawn.contours) {
    const std::size_t layer = contour.entity.layer;
    if (!is_burnt(layer) || !told.insert(layer).second) continue;
    faults.push_back(
        {FaultKind::kBadEntity,
         contour.entity,
         start_of(contour.shapes.front()),
         "its layer has kind=image, which burns pictures only",
         "give its colour a kind of its own; `image: kind=image` names pictures alone"});
  }
  for (const drawing::Fault& fault : drawn.faults) {
    if (fault.kind == FaultKind::kBadPicture && is_burnt(fault.entity.layer)) {
      faults.push_back(fault);
    }
  }
  return faults;
}

bool is_known_picture(const drawing::Fault& note,
                      const drawing::Drawing& drawn,
                      const std::vector<cut::LayerPlan>& layers,
                      const std::vector<cut::LayerRule>& rules) {
  const bool is_of_picture =
      note.kind == FaultKind::kPicture || note.kind == FaultKind::kBadPicture;
  const std::size_t layer = note.entity.layer;
  if (!is_of_picture || layer >= layers.size()) return false;
  if (layers[layer].settings.side == cut::Side::kImage) return true;
  return std::ranges::any_of(rules_for(drawn.layers[layer], rules), [](const cut::LayerRule* rule) {
    return std::ranges::any_of(rule->values, [](const auto& value) {
      return (value.first == "kind" || value.first == "side") && value.second == "skip";
    });
  });
}

}  // namespace sim
