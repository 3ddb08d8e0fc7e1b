#pragma once

#include <cstddef>
#include <cstdint>

#include "planner/pocket/clearing.hpp"
#include "planner/pocket/loop_place.hpp"
#include "planner/pocket/pocket_entry.hpp"
#include "planner/pocket/tool_path.hpp"

namespace cnc::pocket {

/// Options for milling a pocket by the strategy `contour`.
template <typename Scalar>
struct PocketOptions {
  ClearingOptions<Scalar> clearing;
  EntryOptions<Scalar> entry;
  Milling milling = Milling::kClimb;
  Scalar depth{};       ///< Depth below the top of the stock, mm, positive.
  Scalar depth_step{};  ///< Greatest depth of one level, mm; all levels have the same depth.
};

/// State of a pass during the computation of the path. Working storage.
struct PassState {
  /// Number of passes directly within this pass that are not driven yet.
  std::uint32_t waits_for = 0;
  bool is_driven = false;
};

/// Working storage of a path. Its content does not outlive the call. `elements` is that of
/// ClearingSizes.
template <typename Scalar>
struct PocketPathSpace {
  ClearingSpace<Scalar> clearing;
  contour::Slice<PassState> passes;                      ///< States, one for each pass.
  contour::Slice<bool> driven_loops;                     ///< Flags, one for each loop of a pass.
  contour::Slice<contour::Curve<Scalar>> locus;          ///< elements
  contour::Slice<contour::FlatBox<Scalar>> locus_boxes;  ///< BoxTree::size_for(elements)
};

/// Returns the number of equal levels down to a depth, such that no level is deeper than the step.
/// If the depth is a whole number of steps, the result is exactly that number, in spite of
/// rounding.
/// @pre both are positive
template <typename Scalar>
[[nodiscard]] Scalar level_count(Scalar depth, Scalar greatest_step);

enum class PocketFault : std::uint8_t {
  kOptionOutOfRange,  ///< Depth, step, slope or radius of the helix is out of range.
  kClearing,          ///< clear_pocket() failed: see `PocketError::clearing`.
  kToolTooLarge,      ///< The tool fits nowhere in the pocket.
  kSpaceTooSmall,     ///< The working storage is full.
  /// A loop is too short for a ramp, and no helix fits. A plunge is the remedy.
  kNoEntry,
  kPathTooLong,  ///< The storage of the path is full.
};

struct PocketError {
  PocketFault fault{};
  ClearingError clearing{};
};

/// Numbers of passes, levels, rows and links of a path.
struct PocketReport {
  std::uint32_t passes = 0;  ///< Number of passes on each level.
  std::uint32_t levels = 0;
  std::uint32_t rows = 0;
  std::uint32_t links = 0;
};

/// Writes the path that clears a pocket, one level after another. On each level the path leads from
/// the innermost passes outwards.
///
/// A row begins with an entry at its first point, from the floor of the level above or from the top
/// of the stock. It continues from pass to pass as long as there are links. It first goes around
/// all loops of a pass. Then it goes to the pass around them, once all passes within that pass are
/// driven. Links and passes join with one tangent, so with a corner radius only the passes at the
/// wall have corners. The use of a link is kPass, because a link that leads outwards cuts.
///
/// Guarantee: no element is nearer to the wall than the tool's radius by more than 1e-7 mm, and
/// none is below its level. For the passes the guarantee of clear_pocket() holds.
template <typename Scalar>
[[nodiscard]] Result<PocketReport, PocketError> write_pocket_path(
    const contour::ContourView<Scalar>& pocket,
    const PocketOptions<Scalar>& options,
    const PocketPathSpace<Scalar>& space,
    PassList<Scalar>& passes,
    ToolPathWriter<Scalar>& out);

}  // namespace cnc::pocket
