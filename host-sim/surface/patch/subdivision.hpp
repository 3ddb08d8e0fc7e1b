#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "host-sim/surface/patch/flatness.hpp"
#include "host-sim/surface/patch/patch_surface.hpp"

namespace sim::surface::patch {

/// Halvings of each parameter after which a piece is kept although it is not flat.
inline constexpr int kMaxHalvings = 16;

/// The distance from flat that a piece may have, mm; 0 and less is flat.
using Excess = std::function<double(const BezierPatch&)>;

/// The condition under which the chords of a piece are within tolerance.
struct FlatnessLimit {
  double tolerance_mm = 0.5;
  FlatnessTest test = FlatnessTest::kBothOrders;
  /// Unit normal of the slicing planes. With it the tolerance holds for chords within these planes,
  /// in which a fat plane that is oblique to them is thicker; without it, along the fat plane's
  /// normal alone, as in paper 4.
  std::optional<Eigen::Vector3d> slicing_normal;
};

/// Returns how far chords between points of the patch can be from it, as the limit measures it; at
/// most the diameter of the control points.
[[nodiscard]] double chord_error_bound(const BezierPatch& patch, const FlatnessLimit& limit);

/// Returns flat pieces of a patch by splits in four (paper 4).
[[nodiscard]] std::vector<GridPatch> quartered(const GridPatch& patch, const FlatnessLimit& limit);
/// The same with a test of the caller's.
[[nodiscard]] std::vector<GridPatch> quartered(const GridPatch& patch, const Excess& excess);

/// Returns flat pieces of a patch by splits in two: of all sequences of halvings that a search with
/// a memory tries, the one with the fewest pieces. It leaves out the worse direction of a split
/// where that hardly helps, without which a ruled patch would take a time of the square.
[[nodiscard]] std::vector<GridPatch> halved(const GridPatch& patch, const FlatnessLimit& limit);

/// Returns the flat pieces of all patches by splits in two.
[[nodiscard]] std::vector<GridPatch> flat_pieces(const PatchSurface& surface,
                                                 const FlatnessLimit& limit);

}  // namespace sim::surface::patch
