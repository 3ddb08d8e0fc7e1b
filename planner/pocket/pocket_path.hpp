#pragma once

#include <cstddef>
#include <cstdint>

#include "planner/pocket/clearing.hpp"
#include "planner/pocket/loop_place.hpp"
#include "planner/pocket/pocket_entry.hpp"
#include "planner/pocket/tool_path.hpp"

namespace cnc::pocket {

/// How a pocket is milled by the strategy `contour`.
template <typename Scalar>
struct PocketOptions {
  ClearingOptions<Scalar> clearing;
  EntryOptions<Scalar> entry;
  Milling milling = Milling::kClimb;
  Scalar depth{};       ///< mm below the top of the stock, positive.
  Scalar depth_step{};  ///< Greatest depth of one level, mm; all levels are equal.
};

/// A pass while the path is made. Working storage.
struct PassState {
  std::uint32_t waits_for = 0;  ///< Passes within it that are not driven.
  bool is_driven = false;
};

/// Working storage of a path; nothing in it outlives the call.
template <typename Scalar>
struct PocketPathSpace {
  ClearingSpace<Scalar> clearing;
  contour::Slice<PassState> passes;                      ///< One for each pass.
  contour::Slice<bool> driven_loops;                     ///< One for each loop of a pass.
  contour::Slice<contour::Curve<Scalar>> locus;          ///< elements
  contour::Slice<contour::FlatBox<Scalar>> locus_boxes;  ///< BoxTree::size_for(elements)
};

/// Returns the number of equal levels, none of them deeper than the step, that reach a depth. A
/// depth of a whole number of steps takes just so many, however it was rounded.
/// @pre both are positive
template <typename Scalar>
[[nodiscard]] Scalar level_count(Scalar depth, Scalar greatest_step);

enum class PocketFault : std::uint8_t {
  kOptionOutOfRange,  ///< Depth, step, slope or radius of the helix.
  kClearing,          ///< See `clearing`.
  kToolTooLarge,      ///< The tool fits nowhere.
  kSpaceTooSmall,     ///< The working storage is full.
  kNoEntry,           ///< A loop is too short for a ramp, and no helix fits: plunge there.
  kPathTooLong,       ///< The storage of the path is full.
};

struct PocketError {
  PocketFault fault{};
  ClearingError clearing{};
};

/// What a path consists of.
struct PocketReport {
  std::uint32_t passes = 0;  ///< Of each level.
  std::uint32_t levels = 0;
  std::uint32_t rows = 0;
  std::uint32_t links = 0;
};

/// Writes the path that clears a pocket, level after level, in each from the innermost passes
/// outwards.
///
/// A row begins with an entry from the floor of the level above, or from the top of the stock,
/// where its first point is, and goes on over links from pass to pass for as long as there are any:
/// around all loops of a pass, then to the pass around it once all passes within that are driven.
/// Links and passes have one tangent where they join, so that with a corner radius only the passes
/// at the wall have corners. Links are passes by their use: where they lead outwards they cut.
///
/// Guarantee: no element is nearer to the wall than the tool's radius by more than 1e-7 mm, nor
/// below its level; passes have the guarantee of clear_pocket().
template <typename Scalar>
[[nodiscard]] Result<PocketReport, PocketError> write_pocket_path(
    const contour::ContourView<Scalar>& pocket,
    const PocketOptions<Scalar>& options,
    const PocketPathSpace<Scalar>& space,
    PassList<Scalar>& passes,
    ToolPathWriter<Scalar>& out);

}  // namespace cnc::pocket
