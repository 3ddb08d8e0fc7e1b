#pragma once

#include "planner/contour/node_set.hpp"
#include "planner/contour/offset_space.hpp"

namespace cnc::contour {

/// Chooses the runs of the result. It keeps the runs that are at the offset distance from the
/// input. Optional runs are at this distance only within the tolerance. Of the optional runs it
/// keeps those that are required to lead every loop back to its start.
template <typename Scalar>
class RunSelection {
 public:
  RunSelection(const OffsetSpace<Scalar>& space,
               const Tolerance<Scalar>& tolerance,
               const NodeSet<Scalar>& nodes,
               Scalar distance)
      : space_{space},
        tolerance_{tolerance},
        nodes_{nodes},
        distance_{std::abs(distance)},
        tree_{space.element_boxes} {}

  /// Sets the standing of every run. Returns false if a loop cannot be closed.
  [[nodiscard]] bool select(std::uint32_t element_count, std::uint32_t run_count);

 private:
  using Vector = BasicVec2<Scalar>;

  [[nodiscard]] Standing judge(const Run& run) const;
  [[nodiscard]] Scalar excess_nearness(const Vector& place) const;
  void connect();
  void keep(std::uint32_t run);
  [[nodiscard]] bool lead_on(std::uint32_t node);
  void forget(std::uint32_t reached);

  OffsetSpace<Scalar> space_;
  Tolerance<Scalar> tolerance_;
  const NodeSet<Scalar>& nodes_;
  Scalar distance_;
  BoxTree<Scalar> tree_;
  std::uint32_t run_count_ = 0;
};

}  // namespace cnc::contour
