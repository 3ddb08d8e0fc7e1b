#pragma once

#include <cstdint>

#include "planner/pocket/loop_place.hpp"
#include "planner/pocket/nearest_curve.hpp"
#include "planner/pocket/tool_path.hpp"

namespace cnc::pocket {

/// Method by which the tool descends into stock.
enum class EntryKind : std::uint8_t {
  kHelix,  ///< A helix where a circle fits; a ramp elsewhere.
  kRamp,   ///< Down along the first pass, in as many revolutions as necessary.
  /// Straight down, for tools that cut at their centre and for holes that are already drilled.
  kPlunge,
};

template <typename Scalar>
struct EntryOptions {
  EntryKind kind = EntryKind::kHelix;
  /// Steepest descent of a helix or a ramp divided by its length, above 0, at most 1.
  Scalar slope{};
  /// Greatest radius of a helix, mm; more than the tool's radius would leave a core.
  Scalar helix_radius{};
};

/// A path into the stock: the point where the first pass begins, and the helix that ends there.
template <typename Scalar>
struct EntryPlan {
  EntryKind kind = EntryKind::kPlunge;
  LoopPlace<Scalar> place;
  Scalar helix_radius{};  ///< mm; the circle lies on that side of the pose where the area is.
};

/// Chooses an entry to a loop. The helix is a circle that touches the loop from within at the
/// middle of one of its elements, so that their tangents agree. The radius is halved up to three
/// times until the circle fits. Of all middles, the one with the greatest circle is taken. Where no
/// circle fits, the entry is a ramp.
///
/// Guarantee: no point of the helix is outside of the locus.
/// @param locus  boundary of the area where the tool's centre may be
/// @param boundary  the elements of `locus`
/// @param area  the loops of the first pass
template <typename Scalar>
[[nodiscard]] EntryPlan<Scalar> plan_entry(const contour::ContourView<Scalar>& locus,
                                           const NearestCurve<Scalar>& boundary,
                                           const contour::ContourView<Scalar>& area,
                                           std::size_t loop,
                                           Milling milling,
                                           const EntryOptions<Scalar>& options);

/// Heights between which an entry descends, mm.
template <typename Scalar>
struct Descent {
  Scalar from{};
  Scalar to{};
};

enum class EntryResult : std::uint8_t {
  kDone,
  kTooShort,  ///< The loop is so short that a ramp would take more than 1000 revolutions.
  kFull,      ///< The storage of the path is full.
};

/// Appends the descent, which ends at the plan's point. Above `descent.from` the stock must be gone
/// there. The end is not appended: the pass begins with it.
template <typename Scalar>
[[nodiscard]] EntryResult write_entry(const EntryPlan<Scalar>& plan,
                                      const contour::ContourView<Scalar>& area,
                                      Milling milling,
                                      const EntryOptions<Scalar>& options,
                                      const Descent<Scalar>& descent,
                                      ToolPathWriter<Scalar>& out);

}  // namespace cnc::pocket
