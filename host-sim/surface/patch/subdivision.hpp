#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "host-sim/surface/patch/flatness.hpp"
#include "host-sim/surface/patch/patch_surface.hpp"

namespace sim::surface::patch {

/// Number of halvings of each parameter after which a piece is kept even if it is not flat.
inline constexpr int kMaxHalvings = 16;

/// Distance in mm by which a piece exceeds the flatness limit; a piece with 0 or less is flat.
using Excess = std::function<double(const BezierPatch&)>;

/// The condition under which the chords of a piece are within tolerance.
struct FlatnessLimit {
  double tolerance_mm = 0.5;
  FlatnessTest test = FlatnessTest::kBothOrders;
  /// Unit normal of the slicing planes. With it, the tolerance applies to distances within these
  /// planes, in which a fat plane that is oblique to them is thicker. Without it, the tolerance
  /// applies along the fat plane's normal alone, as in paper 4.
  std::optional<Eigen::Vector3d> slicing_normal = std::nullopt;
  /// A piece that is parallel to the slicing planes to within this sine gets a tolerance that is
  /// divided by this sine. With the exact sine, level ground would be divided without end, although
  /// its paths lie on it anyway.
  double min_sine = 0.05;
};

/// Returns an upper bound of the distance between the patch and chords between its points, measured
/// as the limit requires; at most the diameter of the control points.
[[nodiscard]] double chord_error_bound(const BezierPatch& patch, const FlatnessLimit& limit);

/// Returns flat pieces of a patch by splits in four (paper 4).
[[nodiscard]] std::vector<GridPatch> quartered(const GridPatch& patch, const FlatnessLimit& limit);
/// Returns flat pieces of a patch by splits in four until `excess` is 0 or less.
[[nodiscard]] std::vector<GridPatch> quartered(const GridPatch& patch, const Excess& excess);

/// Returns flat pieces of a patch by splits in two. A search with a memory tries sequences of
/// halvings and returns one with the fewest pieces, never more than splits in four give. It tries
/// the worse one of the two directions only if that direction makes the halves flatter, too, or if
/// neither direction does.
[[nodiscard]] std::vector<GridPatch> halved(const GridPatch& patch, const FlatnessLimit& limit);

/// Returns the flat pieces of all patches by splits in two.
[[nodiscard]] std::vector<GridPatch> flat_pieces(const PatchSurface& surface,
                                                 const FlatnessLimit& limit);

}  // namespace sim::surface::patch
