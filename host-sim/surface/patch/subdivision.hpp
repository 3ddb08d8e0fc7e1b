#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "host-sim/surface/patch/flatness.hpp"
#include "host-sim/surface/patch/patch_surface.hpp"

namespace sim::surface::patch {

/// Maximum number of halvings of each parameter. After that, a piece is kept even if it is not
/// flat.
inline constexpr int kMaxHalvings = 16;

/// Function that returns the distance in mm by which a piece exceeds a flatness limit. A piece with
/// 0 or less is flat.
using Excess = std::function<double(const BezierPatch&)>;

/// The condition under which the chords of a piece are within tolerance.
struct FlatnessLimit {
  double tolerance_mm = 0.5;
  FlatnessTest test = FlatnessTest::kBothOrders;
  /// Unit normal of the slicing planes. With a value, the tolerance applies to distances within the
  /// slicing planes. Measured in an oblique slicing plane, the thickness of a fat plane is greater
  /// than along its normal. Without a value, the tolerance applies along the fat plane's normal, as
  /// in paper 4.
  std::optional<Eigen::Vector3d> slicing_normal = std::nullopt;
  /// Lower limit of the sine of the angle between a piece and the slicing planes. The error within
  /// the slicing planes is the thickness divided by the sine. Without the limit, a piece that is
  /// almost parallel to the slicing planes would be divided without end.
  double min_sine = 0.05;
};

/// Returns an upper bound of the distance between a patch and chords between its points, measured
/// as `limit` requires. The bound is at most the diameter of the control points.
[[nodiscard]] double chord_error_bound(const BezierPatch& patch, const FlatnessLimit& limit);

/// Divides a patch into flat pieces by splits in four (paper 4).
[[nodiscard]] std::vector<GridPatch> quartered(const GridPatch& patch, const FlatnessLimit& limit);
/// Divides a patch by splits in four until `excess` of each piece is 0 or less.
[[nodiscard]] std::vector<GridPatch> quartered(const GridPatch& patch, const Excess& excess);

/// Divides a patch into flat pieces by splits in two. Tries sequences of halvings and returns the
/// pieces of the sequence with the fewest pieces. Their number never exceeds the number by splits
/// in four. The worse of the two directions is tried only if both directions make the halves
/// flatter or neither does.
[[nodiscard]] std::vector<GridPatch> halved(const GridPatch& patch, const FlatnessLimit& limit);

/// Divides all patches into flat pieces by splits in two, see halved().
[[nodiscard]] std::vector<GridPatch> flat_pieces(const PatchSurface& surface,
                                                 const FlatnessLimit& limit);

}  // namespace sim::surface::patch
