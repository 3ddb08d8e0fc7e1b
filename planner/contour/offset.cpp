#include "planner/contour/offset.hpp"

#include <cmath>
#include <limits>

#include "planner/contour/cutting.hpp"
#include "planner/contour/loop_writer.hpp"
#include "planner/contour/raw_offset.hpp"
#include "planner/contour/run_selection.hpp"
#include "planner/contour/runs.hpp"

namespace cnc::contour {
namespace {

/// Returns the greatest absolute coordinate of the input, or a value that is not finite if the
/// input has such a value.
template <typename Scalar>
Scalar reach_of(const ContourView<Scalar>& input) {
  Scalar most{};
  Scalar faults{};  // Stays 0 while all values are finite; otherwise it becomes NaN.
  for (const Vertex<Scalar>& vertex : input.vertices) {
    most = std::max(most, std::max(std::abs(vertex.x), std::abs(vertex.y)));
    faults += Scalar{0} * (vertex.x + vertex.y + vertex.bulge);
  }
  return most + faults;
}

/// Returns the number of elements. An arc of more than half a turn counts as two elements.
template <typename Scalar>
std::size_t element_count(const ContourView<Scalar>& input) {
  std::size_t count = input.vertices.size();
  for (const Vertex<Scalar>& vertex : input.vertices) count += std::abs(vertex.bulge) > Scalar{1};
  return count;
}

template <typename Scalar>
Result<ContourView<Scalar>, OffsetError> copied(const ContourView<Scalar>& input,
                                                ContourWriter<Scalar>& out) {
  for (std::size_t loop = 0; loop < input.loop_ends.size(); ++loop) {
    for (std::uint32_t i = input.loop_begin(loop); i < input.loop_ends[loop]; ++i) {
      if (!out.add(input.vertices[i])) return OffsetError{OffsetFault::kResultTooLong};
    }
    if (!out.end_loop()) return OffsetError{OffsetFault::kResultTooLong};
  }
  return out.view();
}

}  // namespace

template <typename Scalar>
Tolerance<Scalar> Tolerance<Scalar>::for_coordinates_up_to(Scalar most) {
  // Factor by which the error of a chain of computations may exceed the floating-point resolution.
  // In single precision the resolution is too coarse for a greater factor.
  constexpr Scalar kRoundings = sizeof(Scalar) > sizeof(float) ? Scalar{1024} : Scalar{8};
  const Scalar touch =
      kRoundings * std::numeric_limits<Scalar>::epsilon() * std::max(Scalar{1}, most);
  return {touch, Scalar{64} * touch, Scalar{1024} * touch};
}

template <typename Scalar>
Result<ContourView<Scalar>, OffsetError> offset(const ContourView<Scalar>& input,
                                                Scalar distance,
                                                const OffsetSpace<Scalar>& space,
                                                ContourWriter<Scalar>& out) {
  out.clear();
  const Scalar reach = reach_of(input) + std::abs(distance);
  if (!std::isfinite(reach)) return OffsetError{OffsetFault::kNotANumber};
  const auto tolerance = Tolerance<Scalar>::for_coordinates_up_to(reach);
  if (std::abs(distance) <= tolerance.touch) return copied(input, out);

  RawOffset<Scalar> raw{space, distance, tolerance};
  for (std::size_t loop = 0; loop < input.loop_ends.size(); ++loop) {
    if (!raw.add_loop(input, loop)) {
      return OffsetError{
          OffsetFault::kTooManyElements, element_count(input), space.elements.size()};
    }
  }
  NodeSet<Scalar> nodes{space.nodes, raw.node_count()};
  Cutting<Scalar> cutting{space, tolerance, nodes, raw.raw_count()};
  if (!cutting.find_meetings()) {
    return OffsetError{OffsetFault::kTooManyMeetings, 0, space.cuts.size()};
  }
  const std::uint32_t pieces = cutting.divide();
  const std::uint32_t runs = RunFinder<Scalar>{space, tolerance, nodes, pieces}.find();
  RunSelection<Scalar> selection{space, tolerance, nodes, distance};
  if (!selection.select(raw.element_count(), runs)) return OffsetError{OffsetFault::kNotClosed};
  if (!LoopWriter<Scalar>{space, nodes, out}.write(runs)) {
    return OffsetError{OffsetFault::kResultTooLong};
  }
  return out.view();
}

template struct Tolerance<float>;
template struct Tolerance<double>;
template Result<ContourView<float>, OffsetError> offset(const ContourView<float>&,
                                                        float,
                                                        const OffsetSpace<float>&,
                                                        ContourWriter<float>&);
template Result<ContourView<double>, OffsetError> offset(const ContourView<double>&,
                                                         double,
                                                         const OffsetSpace<double>&,
                                                         ContourWriter<double>&);

}  // namespace cnc::contour
