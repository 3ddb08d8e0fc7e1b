#pragma once

#include <cstdint>

#include "planner/pocket/loop_place.hpp"
#include "planner/pocket/nearest_curve.hpp"
#include "planner/pocket/tool_path.hpp"

namespace cnc::pocket {

/// How the tool gets down into stock.
enum class EntryKind : std::uint8_t {
  kHelix,   ///< Where a circle fits; a ramp elsewhere.
  kRamp,    ///< Down along the first pass, round and round.
  kPlunge,  ///< Straight down, for tools that cut at their centre and for holes drilled before.
};

template <typename Scalar>
struct EntryOptions {
  EntryKind kind = EntryKind::kHelix;
  Scalar slope{};         ///< Steepest descent over length of a helix or a ramp, 0…1 without 0.
  Scalar helix_radius{};  ///< Greatest, mm; more than the tool's radius would leave a core.
};

/// A way into the stock: where the first pass begins, and the helix that ends there.
template <typename Scalar>
struct EntryPlan {
  EntryKind kind = EntryKind::kPlunge;
  LoopPlace<Scalar> place;
  Scalar helix_radius{};  ///< mm; the circle lies on the side of the pose where the area is.
};

/// Chooses an entry to a loop. The helix is a circle that touches the loop from within, in the
/// middle of one of its elements, so that it joins with one tangent. Of all middles the one is
/// taken with the greatest circle, halved up to three times. Without a circle the entry is a ramp.
///
/// Guarantee: no point of the helix is outside of the locus.
/// @param locus  boundary of the area where the tool's centre may be, and its loops
/// @param area  the loops of the first pass
template <typename Scalar>
[[nodiscard]] EntryPlan<Scalar> plan_entry(const contour::ContourView<Scalar>& locus,
                                           const NearestCurve<Scalar>& boundary,
                                           const contour::ContourView<Scalar>& area,
                                           std::size_t loop,
                                           Milling milling,
                                           const EntryOptions<Scalar>& options);

/// The heights between which an entry descends, mm.
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

/// Appends the way down along the descent, which ends at the plan's place and begins above
/// it. The stock above its beginning must be gone there. The end is not appended: the pass begins
/// with it.
template <typename Scalar>
[[nodiscard]] EntryResult write_entry(const EntryPlan<Scalar>& plan,
                                      const contour::ContourView<Scalar>& area,
                                      Milling milling,
                                      const EntryOptions<Scalar>& options,
                                      const Descent<Scalar>& descent,
                                      ToolPathWriter<Scalar>& out);

}  // namespace cnc::pocket
