#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "host-sim/cut/edge_check.hpp"
#include "host-sim/cut/plan.hpp"
#include "host-sim/cut/timeline.hpp"
#include "host-sim/plot/view.hpp"

namespace sim {

// Colours of pictures of cuts. People with red-green colour blindness can distinguish them. In grey
// prints they differ by their lightness and by the widths of the lines. They are from the palette
// of M. Okabe and K. Ito, "Color universal design", 2008.
inline constexpr std::string_view kPartColour = "#d8dde3";
inline constexpr std::string_view kBandColour = "#e69f00";
inline constexpr std::string_view kBeamColour = "#000000";
inline constexpr std::string_view kLeadColour = "#0072b2";
inline constexpr std::string_view kTabRim = "#000000";
inline constexpr std::string_view kTabColour = "#f0e442";
inline constexpr double kTabRimPx = 8.0;
inline constexpr double kTabPx = 4.5;

/// Data from which a picture of cuts is drawn.
struct CutScene {
  const drawing::Drawing& drawn;
  const cut::CutPlan& plan;
  /// Timeline of the job. If null, the picture shows no heat.
  const cut::Timeline* timeline = nullptr;
};

/// Returns the extent of the drawing and the cuts; a point at the origin if both are empty.
[[nodiscard]] Extent extent_of(const CutScene& scene);

/// Returns the extent with a margin. The result always has a width and a height.
[[nodiscard]] Extent framed_cuts(const Extent& extent);

/// Appends the areas of the parts, which the cut contours enclose, and the lines of all other
/// contours.
void add_parts(std::string& out, const CutScene& scene, const View& view);

/// Returns path data of the strokes of a cut for which `wanted` returns true.
[[nodiscard]] std::string path_data_of(const cut::Cut& cut,
                                       const View& view,
                                       bool (*wanted)(const cut::Stroke&));

/// Appends the layers of a picture of cuts: heat, parts, the band that the beam burns (as wide as
/// the kerf), the middle of the band, leads, tabs, rapids and pierces. If deviations of edges were
/// measured, these and their key at `edge_key_px` are appended next. The numbers of the cuts are
/// appended last, so that they are on top.
void add_cut_layers(std::string& out,
                    const CutScene& scene,
                    const View& view,
                    const cut::EdgeFigures* edges = nullptr,
                    double edge_key_px = 0.0);

}  // namespace sim
