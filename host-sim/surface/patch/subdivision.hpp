#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "host-sim/surface/patch/flatness.hpp"
#include "host-sim/surface/patch/patch_surface.hpp"

namespace sim::surface::patch {

/// Halvings of each parameter after which a piece is kept although it is not flat.
inline constexpr int kMaxHalvings = 16;

/// The distance by which a piece is not flat enough, mm; a piece of 0 or less is flat.
using Excess = std::function<double(const BezierPatch&)>;

/// The condition under which the chords of a piece are within tolerance.
struct FlatnessLimit {
  double tolerance_mm = 0.5;
  FlatnessTest test = FlatnessTest::kBothOrders;
  /// Unit normal of the slicing planes. With it the tolerance holds for chords within these planes,
  /// in which a fat plane that is oblique to them is thicker; without it, along the fat plane's
  /// normal alone, as in paper 4.
  std::optional<Eigen::Vector3d> slicing_normal = std::nullopt;
  /// A piece nearly parallel to the slicing planes, by less than this sine, is held to tolerance /
  /// sine alone: level ground would be divided without end, while its paths are on it anyway.
  double least_sine = 0.05;
};

/// Returns a bound of the distance of the patch from chords between its points, as the limit
/// measures it; at most the diameter of the control points.
[[nodiscard]] double chord_error_bound(const BezierPatch& patch, const FlatnessLimit& limit);

/// Returns flat pieces of a patch by splits in four (paper 4).
[[nodiscard]] std::vector<GridPatch> quartered(const GridPatch& patch, const FlatnessLimit& limit);
/// Returns flat pieces by splits in four until `excess` is 0 or less.
[[nodiscard]] std::vector<GridPatch> quartered(const GridPatch& patch, const Excess& excess);

/// Returns flat pieces of a patch by splits in two: of all sequences of halvings that a search with
/// a memory tries, one with the fewest pieces, never more than by splits in four. Of the two
/// directions the worse one is tried if it makes the halves flatter, too.
[[nodiscard]] std::vector<GridPatch> halved(const GridPatch& patch, const FlatnessLimit& limit);

/// Returns the flat pieces of all patches by splits in two.
[[nodiscard]] std::vector<GridPatch> flat_pieces(const PatchSurface& surface,
                                                 const FlatnessLimit& limit);

}  // namespace sim::surface::patch
