#pragma once

#include "planner/contour/meeting.hpp"
#include "planner/contour/node_set.hpp"
#include "planner/contour/offset_space.hpp"

namespace cnc::contour {

/// Divides raw curves at all points where they cross, touch or end on each other.
///
/// A meeting is computed once for both curves, so that both have exactly the same point. Points
/// closer than `touch` become one node before the pieces are made.
template <typename Scalar>
class Cutting {
 public:
  Cutting(const OffsetSpace<Scalar>& space,
          const Tolerance<Scalar>& tolerance,
          NodeSet<Scalar>& nodes,
          std::uint32_t raw_count)
      : space_{space}, tolerance_{tolerance}, nodes_{nodes}, raw_count_{raw_count} {}

  /// Finds all meetings. Returns false if the storage cannot hold all of them.
  [[nodiscard]] bool find_meetings();

  /// Divides the raw curves, and writes the pieces. Returns the number of pieces.
  [[nodiscard]] std::uint32_t divide();

 private:
  using Vector = BasicVec2<Scalar>;

  void index_raw_curves(BoxTree<Scalar>& tree) const;
  void meet(std::uint32_t a, std::uint32_t b);
  [[nodiscard]] bool clear_of(const Curve<Scalar>& line, const Curve<Scalar>& other) const;
  [[nodiscard]] bool beside(const Curve<Scalar>& curve, const Curve<Scalar>& other) const;
  void end_on(const Vector& place, std::uint32_t node, std::uint32_t raw);
  [[nodiscard]] bool is_joint(std::uint32_t a, std::uint32_t b, const Vector& place);
  void meet_at(std::uint32_t a, std::uint32_t b, const Vector& place);
  [[nodiscard]] bool is_near(const Vector& one, const Vector& other) const;
  [[nodiscard]] std::uint32_t end_near(std::uint32_t raw, const Vector& place) const;
  void cut(std::uint32_t raw, std::uint32_t node, const Vector& place);
  void sort_cuts();
  void sort_along(std::uint32_t first, std::uint32_t end);
  void unite_neighbours(std::uint32_t raw);
  void add_piece(std::uint32_t raw, std::uint32_t start_node, std::uint32_t end_node);

  OffsetSpace<Scalar> space_;
  Tolerance<Scalar> tolerance_;
  NodeSet<Scalar>& nodes_;
  std::uint32_t raw_count_;
  std::uint32_t cut_count_ = 0;
  std::uint32_t piece_count_ = 0;
  bool full_ = false;
};

}  // namespace cnc::contour
