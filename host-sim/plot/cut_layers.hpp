#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "host-sim/cut/edge_check.hpp"
#include "host-sim/cut/plan.hpp"
#include "host-sim/cut/timeline.hpp"
#include "host-sim/plot/view.hpp"

namespace sim {

// Colours told apart by people who are blind to red and green, and in grey, by lightness and by
// the widths of the lines: of the palette of M. Okabe and K. Ito, "Color universal design", 2008.
inline constexpr std::string_view kPartColour = "#d8dde3";
inline constexpr std::string_view kBandColour = "#e69f00";
inline constexpr std::string_view kBeamColour = "#000000";
inline constexpr std::string_view kLeadColour = "#0072b2";
inline constexpr std::string_view kTabRim = "#000000";
inline constexpr std::string_view kTabColour = "#f0e442";
inline constexpr double kTabRimPx = 8.0;
inline constexpr double kTabPx = 4.5;

/// What a picture of cuts is drawn from.
struct CutScene {
  const drawing::Drawing& drawn;
  const cut::CutPlan& plan;
  const cut::Timeline* timeline = nullptr;  ///< Null: the picture shows no heat.
};

/// Returns what drawing and cuts cover; a point at the origin where there is neither.
[[nodiscard]] Extent extent_of(const CutScene& scene);

/// Returns the extent with a margin, never a mere point.
[[nodiscard]] Extent framed_cuts(const Extent& extent);

/// Appends the parts, which are the areas that cut contours enclose, and the lines of all other
/// contours.
void add_parts(std::string& out, const CutScene& scene, const View& view);

/// Appends one cut's strokes for which `wanted` holds as path data.
[[nodiscard]] std::string path_data_of(const cut::Cut& cut,
                                       const View& view,
                                       bool (*wanted)(const cut::Stroke&));

/// Appends heat, parts, the band that the beam burns in the width of the kerf, its middle, leads,
/// tabs, rapids and pierces; edges where they were measured, with their key at `edge_key_px`;
/// and numbers above all of that.
void add_cut_layers(std::string& out,
                    const CutScene& scene,
                    const View& view,
                    const cut::EdgeFigures* edges = nullptr,
                    double edge_key_px = 0.0);

}  // namespace sim
