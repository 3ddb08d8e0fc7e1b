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
  Scalar depth{};       ///< mm below the top of the stock, positive.
  Scalar depth_step{};  ///< Greatest depth of one level, mm; all levels are equally deep.
};

/// State of a pass while the path is made. Working storage.
struct PassState {
  std::uint32_t waits_for = 0;  ///< Number of passes directly within it that are not driven yet.
  bool is_driven = false;
};

/// Working storage of a path. Nothing in it outlives the call.
template <typename Scalar>
struct PocketPathSpace {
  ClearingSpace<Scalar> clearing;
  contour::Slice<PassState> passes;                      ///< One for each pass.
  contour::Slice<bool> driven_loops;                     ///< One for each loop of a pass.
  contour::Slice<contour::Curve<Scalar>> locus;          ///< elements
  contour::Slice<contour::FlatBox<Scalar>> locus_boxes;  ///< BoxTree::size_for(elements)
};

/// Returns the number of equal levels that reach a depth, none of them deeper than the step. A
/// depth of a whole number of steps takes exactly that number, in spite of rounding.
/// @pre both are positive
template <typename Scalar>
[[nodiscard]] Scalar level_count(Scalar depth, Scalar greatest_step);

enum class PocketFault : std::uint8_t {
  kOptionOutOfRange,  ///< Depth, step, slope or radius of the helix is out of range.
  kClearing,          ///< clear_pocket() failed: see `PocketError::clearing`.
  kToolTooLarge,      ///< The tool does not fit anywhere in the pocket.
  kSpaceTooSmall,     ///< The working storage is full.
  kNoEntry,           ///< A loop is too short for a ramp, and no helix fits: plunge is the remedy.
  kPathTooLong,       ///< The storage of the path is full.
};

struct PocketError {
  PocketFault fault{};
  ClearingError clearing{};
};

/// Numbers of the parts of a path.
struct PocketReport {
  std::uint32_t passes = 0;  ///< Number of passes of each level.
  std::uint32_t levels = 0;
  std::uint32_t rows = 0;
  std::uint32_t links = 0;
};

/// Writes the path that clears a pocket, one level after another. On each level it drives from the
/// innermost passes outwards.
///
/// A row begins with an entry at its first point, from the floor of the level above or from the top
/// of the stock. It continues from pass to pass as long as there are links: around all loops of a
/// pass, then to the pass around it once all passes within that pass are driven. Links and passes
/// join with one tangent, so with a corner radius only the passes at the wall have corners. The use
/// of a link is kPass: where it leads outwards, it cuts.
///
/// Guarantee: no element is nearer to the wall than the tool's radius by more than 1e-7 mm, and
/// none is below its level. Passes have the guarantee of clear_pocket().
template <typename Scalar>
[[nodiscard]] Result<PocketReport, PocketError> write_pocket_path(
    const contour::ContourView<Scalar>& pocket,
    const PocketOptions<Scalar>& options,
    const PocketPathSpace<Scalar>& space,
    PassList<Scalar>& passes,
    ToolPathWriter<Scalar>& out);

}  // namespace cnc::pocket
