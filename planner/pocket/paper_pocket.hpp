#pragma once

#include <cstdint>

#include "planner/base/result.hpp"
#include "planner/contour/contour.hpp"
#include "planner/contour/curve.hpp"
#include "planner/pocket/tool_path.hpp"

namespace cnc::pocket {

/// The tool of paper 5's program.
template <typename Scalar>
struct PaperTool {
  Scalar radius{};  ///< R, mm.
  Scalar z{};       ///< mm, of the whole path.
  /// Vertical distance by which a line along neither axis moves when its offset is 1 mm. 0 is the
  /// exact √(1 + m²) of its slope m; the paper's own program had 1.516719 where 1.505200 is exact.
  Scalar slant_factor{};
};

enum class PaperFault : std::uint8_t {
  kNotANumber,       ///< The radius is not positive, or a coordinate is no finite number.
  kNotOneLoop,       ///< The pocket has islands, or fewer than two elements.
  kTooManyElements,  ///< The storage of the elements is full.
  kToolTooLarge,     ///< There is no pass at R.
  kTooManyPasses,    ///< The storage of the distances is full.
  kPathTooLong,      ///< The storage of the path is full.
};

/// Working storage of the paper's program.
template <typename Scalar>
struct PaperSpace {
  contour::Slice<contour::Curve<Scalar>> elements;  ///< One for each element of the pocket.
  contour::Slice<Scalar> distances;                 ///< One for each pass.
};

/// The path of paper 5, kept to as printed: Oh and Kwon 2003, sections 2.3 to 3.2.
///
/// The first loop is R from the wall; each next one is R (1 + sin(θ / 2)) farther inside, where θ
/// is the smallest vertex angle of the loop before, as equations 4 to 10 have it: of the tangents,
/// and modulo 180°. Elements that join with one tangent have no vertex. The missing equation 8, of
/// two arcs, follows the others. Each vertex is where both elements meet that are moved by
/// themselves; there are loops until one turns around. The path is a spiral from the innermost loop
/// outwards: it follows the last element of a loop until this meets the first element of the next
/// loop.
///
/// For convex vertices and a single wall. It leaves stock where arcs or short elements make the
/// formula too large; clear_pocket() does not.
/// Returns the number of loops; `space.distances` holds their distances from the wall, mm, from the
/// wall inwards. The path is one row of `out`.
template <typename Scalar>
[[nodiscard]] Result<std::uint32_t, PaperFault> write_paper_path(
    const contour::ContourView<Scalar>& pocket,
    const PaperTool<Scalar>& tool,
    const PaperSpace<Scalar>& space,
    ToolPathWriter<Scalar>& out);

}  // namespace cnc::pocket
