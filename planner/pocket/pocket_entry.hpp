#pragma once

#include <cstdint>

#include "planner/pocket/loop_place.hpp"
#include "planner/pocket/nearest_curve.hpp"
#include "planner/pocket/tool_path.hpp"

namespace cnc::pocket {

/// Method by which the tool descends into stock.
enum class EntryKind : std::uint8_t {
  kHelix,  ///< Descends along a helix if a circle fits, otherwise along a ramp.
  kRamp,   ///< Descends along the first pass, in as many revolutions as necessary.
  /// Descends vertically, for tools that cut at their centre and for holes that are already
  /// drilled.
  kPlunge,
};

template <typename Scalar>
struct EntryOptions {
  EntryKind kind = EntryKind::kHelix;
  /// Greatest slope of a helix or a ramp: descent divided by length, above 0, at most 1.
  Scalar slope{};
  /// Greatest radius of a helix, mm. A radius greater than the tool's radius would leave a core.
  Scalar helix_radius{};
};

/// A path into the stock: the point where the first pass begins, and the descent that ends at this
/// point.
template <typename Scalar>
struct EntryPlan {
  EntryKind kind = EntryKind::kPlunge;
  LoopPlace<Scalar> place;
  /// Radius of the helix, mm. Its circle is on the side of the pose on which the area is.
  Scalar helix_radius{};
};

/// Chooses an entry to a loop. The helix is a circle that touches the loop from inside at the
/// middle of one of its elements, so that their tangents agree. The radius is halved up to three
/// times until the circle fits. The middle with the greatest circle is chosen. If no circle fits,
/// the entry is a ramp.
///
/// Guarantee: no point of the helix is outside the locus.
/// @param locus  boundary of the area in which the tool's centre may be
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

/// Appends the descent, which ends at the plan's point. At this point there must be no stock above
/// `descent.from`. The end of the descent is not appended, because the pass begins with it.
template <typename Scalar>
[[nodiscard]] EntryResult write_entry(const EntryPlan<Scalar>& plan,
                                      const contour::ContourView<Scalar>& area,
                                      Milling milling,
                                      const EntryOptions<Scalar>& options,
                                      const Descent<Scalar>& descent,
                                      ToolPathWriter<Scalar>& out);

}  // namespace cnc::pocket
