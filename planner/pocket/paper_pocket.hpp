#pragma once

#include <cstdint>

#include "planner/base/result.hpp"
#include "planner/contour/contour.hpp"
#include "planner/contour/curve.hpp"
#include "planner/pocket/tool_path.hpp"

namespace cnc::pocket {

/// The tool in the program of paper 5.
template <typename Scalar>
struct PaperTool {
  Scalar radius{};  ///< R, mm.
  Scalar z{};       ///< Height of the complete path, mm.
  /// Vertical distance by which a slanted line moves when its offset is 1 mm. A slanted line is
  /// parallel to neither axis. The value 0 selects the exact factor √(1 + m²) for the line's slope
  /// m. The paper's own program used 1.516719 where 1.505200 is exact.
  Scalar slant_factor{};
};

enum class PaperFault : std::uint8_t {
  kNotANumber,       ///< The radius is not positive, or a coordinate is not a finite number.
  kNotOneLoop,       ///< The pocket has islands, or fewer than two elements.
  kTooManyElements,  ///< The storage of the elements is full.
  kToolTooLarge,     ///< No pass exists, not even the pass at the distance R from the wall.
  kTooManyPasses,    ///< The storage of the distances is full.
  kPathTooLong,      ///< The storage of the path is full.
};

/// Working storage of the paper's program.
template <typename Scalar>
struct PaperSpace {
  contour::Slice<contour::Curve<Scalar>> elements;  ///< Elements of the pocket's wall.
  contour::Slice<Scalar> distances;                 ///< Distances from the wall, one for each pass.
};

/// Writes the path of paper 5 as printed: Oh and Kwon 2003, sections 2.3 to 3.2.
///
/// The first loop is R from the wall. Each next loop is R (1 + sin(θ / 2)) farther inside, where θ
/// is the smallest vertex angle of the previous loop. As in equations 4 to 10, θ is the angle
/// between the tangents, modulo 180°. Elements that join with one tangent have no vertex. Equation
/// 8, for two arcs, is missing in the paper; here it is derived like the other equations. Each
/// vertex is the intersection of two elements that were moved separately. The series of loops ends
/// before the first loop in which an element would be reversed. The path is a spiral from the
/// innermost loop outwards: it follows the last element of a loop up to its intersection with the
/// first element of the next loop.
///
/// The path is meant for convex vertices and a single wall. Where arcs or short elements make the
/// step of the formula too large, the path leaves stock; the passes of clear_pocket() leave none.
/// `space.distances` receives the distances of the loops from the wall, mm, from the wall inwards.
/// The path is one row of `out`.
/// @return the number of loops
template <typename Scalar>
[[nodiscard]] Result<std::uint32_t, PaperFault> write_paper_path(
    const contour::ContourView<Scalar>& pocket,
    const PaperTool<Scalar>& tool,
    const PaperSpace<Scalar>& space,
    ToolPathWriter<Scalar>& out);

}  // namespace cnc::pocket
