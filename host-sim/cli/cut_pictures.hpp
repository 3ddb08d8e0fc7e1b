#pragma once

#include <vector>

#include "host-sim/cli/cut_layers.hpp"
#include "host-sim/cut/burnt_pictures.hpp"

namespace sim {

/// Removes from a drawing all pictures that the rules of a call do not burn. Keeps the digests of
/// the files of the remaining pictures in `inputs`.
void keep_burnt_pictures(const CutCommandOptions& options,
                         const std::vector<cut::LayerRule>& rules,
                         drawing::Drawing& drawn,
                         InputFiles& inputs);

/// Returns the cuts of the pictures in `drawn`, see cut::picture_cuts(). If the program is for a
/// controller other than Kerfline, each line of their rows has one S.
[[nodiscard]] std::vector<cut::Cut> picture_cuts_of(const CutCommandOptions& options,
                                                    const drawing::Drawing& drawn,
                                                    const std::vector<cut::LayerPlan>& layers,
                                                    const cut::Beam& beam,
                                                    const cut::OrderWish& machine,
                                                    std::vector<drawing::Fault>& warnings);

/// Returns power and feed of pictures. Throws std::invalid_argument if the layer lacks one of them.
[[nodiscard]] cut::Condition picture_condition(const cut::LayerSettings& settings,
                                               std::uint32_t thickness_um);

/// Returns faults of the layers that burn pictures: contours in these layers, and pictures that
/// cannot be read.
[[nodiscard]] std::vector<drawing::Fault> picture_faults(const drawing::Drawing& drawn,
                                                         const std::vector<cut::LayerPlan>& layers);

/// Returns whether a note is about a picture that is burnt or that a rule leaves out.
[[nodiscard]] bool is_known_picture(const drawing::Fault& note,
                                    const drawing::Drawing& drawn,
                                    const std::vector<cut::LayerPlan>& layers,
                                    const std::vector<cut::LayerRule>& rules);

}  // namespace sim
