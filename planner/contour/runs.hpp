#pragma once

#include "planner/contour/node_set.hpp"
#include "planner/contour/offset_space.hpp"

namespace cnc::contour {

/// Joins pieces into runs, which are kept or dropped as a unit. Before this, drops the pieces that
/// need no decision: coincident pieces, and pieces that lead to a loose end.
template <typename Scalar>
class RunFinder {
 public:
  RunFinder(const OffsetSpace<Scalar>& space,
            const Tolerance<Scalar>& tolerance,
            const NodeSet<Scalar>& nodes,
            std::uint32_t piece_count)
      : space_{space}, tolerance_{tolerance}, nodes_{nodes}, piece_count_{piece_count} {}

  /// Writes the runs. Returns the number of runs.
  [[nodiscard]] std::uint32_t find();

 private:
  void connect();
  void cancel_if_double(std::uint32_t piece);
  [[nodiscard]] bool coincide(const Piece& a, const Piece& b) const;
  void drop(std::uint32_t piece);
  void drop_from_loose_start(std::uint32_t piece);
  void drop_to_loose_end(std::uint32_t piece);
  [[nodiscard]] std::uint32_t following(std::uint32_t piece) const;
  [[nodiscard]] std::uint32_t only_in(std::uint32_t node) const;
  void add_run(std::uint32_t piece);

  OffsetSpace<Scalar> space_;
  Tolerance<Scalar> tolerance_;
  const NodeSet<Scalar>& nodes_;
  std::uint32_t piece_count_;
  std::uint32_t run_count_ = 0;
};

}  // namespace cnc::contour
