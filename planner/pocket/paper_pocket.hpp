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
  Scalar z{};       ///< Height of the whole path, mm.
  /// Vertical distance by which a slanted line moves when its offset is 1 mm. A slanted line is
  /// parallel to neither axis. 0 selects the exact √(1 + m²) of its slope m; the paper's own
  /// program had 1.516719 where 1.505200 is exact.
  Scalar slant_factor{};
};

enum class PaperFault : std::uint8_t {
  kNotANumber,       ///< The radius is not positive, or a coordinate is not a finite number.
  kNotOneLoop,       ///< The pocket has islands, or fewer than two elements.
  kTooManyElements,  ///< The storage of the elements is full.
  kToolTooLarge,     ///< Not even one pass exists, at the distance R from the wall.
  kTooManyPasses,    ///< The storage of the distances is full.
  kPathTooLong,      ///< The storage of the path is full.
};

/// Working storage of the paper's program.
template <typename Scalar>
struct PaperSpace {
  contour::Slice<contour::Curve<Scalar>> elements;  ///< One for each element of the pocket.
  contour::Slice<Scalar> distances;                 ///< One for each pass.
};

/// Writes the path of paper 5 as printed: Oh and Kwon 2003, sections 2.3 to 3.2.
///
/// The first loop is R from the wall. Each next loop is R (1 + sin(θ / 2)) farther inside, where θ
/// is the smallest vertex angle of the previous loop. As in equations 4 to 10, the angle is that of
/// the tangents, modulo 180°. Elements that join with one tangent have no vertex. Equation 8, of
/// two arcs, is missing in the paper; here it follows the other equations. Each vertex is the
/// meeting of two elements, each moved by itself. The series of loops ends before the first loop in
/// which an element would be reversed. The path is a spiral from the innermost loop outwards: it
/// follows the last element of a loop until this element meets the first element of the next loop.
///
/// The path is meant for convex vertices and a single wall. It leaves stock where arcs or short
/// elements make the formula too large; clear_pocket() does not.
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
