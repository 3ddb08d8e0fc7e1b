#pragma once

#include "planner/contour/contour.hpp"
#include "planner/contour/node_set.hpp"
#include "planner/contour/offset_space.hpp"

namespace cnc::contour {

/// Follows the kept runs around their loops and writes the loops. If several runs leave a node, the
/// leftmost run is next, so that loops may touch but never cross.
template <typename Scalar>
class LoopWriter {
 public:
  LoopWriter(const OffsetSpace<Scalar>& space,
             const NodeSet<Scalar>& nodes,
             ContourWriter<Scalar>& out)
      : space_{space}, nodes_{nodes}, out_{out} {}

  /// Writes all loops. Returns false if the storage of the result is full.
  /// @pre at every node as many kept runs leave as arrive
  [[nodiscard]] bool write(std::uint32_t run_count);

 private:
  using Vector = BasicVec2<Scalar>;

  struct Direction {
    Vector tangent;
    Scalar curvature;
  };

  [[nodiscard]] bool write_loop(std::uint32_t run);
  [[nodiscard]] bool write_run(const Run& run);
  [[nodiscard]] bool flush();
  [[nodiscard]] std::uint32_t next_run(std::uint32_t node, const Piece& arriving) const;
  [[nodiscard]] Direction leaving(const Run& run) const;
  [[nodiscard]] static bool comes_first(const Direction& back,
                                        const Direction& one,
                                        const Direction& other);
  [[nodiscard]] static Scalar clockwise(const Direction& back, const Direction& way);

  OffsetSpace<Scalar> space_;
  const NodeSet<Scalar>& nodes_;
  ContourWriter<Scalar>& out_;
  /// Last piece. It is written later, because more pieces of the same raw curve may follow.
  Piece pending_{};
};

}  // namespace cnc::contour
