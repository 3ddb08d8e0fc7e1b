#pragma once

#include "planner/contour/contour.hpp"
#include "planner/contour/offset_space.hpp"

namespace cnc::contour {

/// Moves every element individually and adds a round join at each corner where that opens a gap. At
/// a corner where moved elements overlap instead, both keep their full length and have loose ends.
/// An arc whose radius is used up is omitted, because each of its points would be nearer to another
/// point of the same arc.
template <typename Scalar>
class RawOffset {
 public:
  RawOffset(const OffsetSpace<Scalar>& space, Scalar distance, const Tolerance<Scalar>& tolerance)
      : space_{space}, distance_{distance}, tolerance_{tolerance} {}

  /// Adds one loop. Call it for all loops in order. Returns false if the storage cannot hold all
  /// elements.
  [[nodiscard]] bool add_loop(const ContourView<Scalar>& contour, std::size_t loop);

  [[nodiscard]] std::uint32_t element_count() const { return element_count_; }
  [[nodiscard]] std::uint32_t raw_count() const { return raw_count_; }
  [[nodiscard]] std::uint32_t node_count() const { return node_count_; }

 private:
  using Vector = BasicVec2<Scalar>;

  void add_moved(const Curve<Scalar>& element);
  void add_join(const Curve<Scalar>& before, const Curve<Scalar>& after);
  [[nodiscard]] Scalar bend_of_moved(const Curve<Scalar>& element) const;
  [[nodiscard]] bool closes(const Vector& gap, Scalar curvature) const;
  [[nodiscard]] bool draws_together(const Curve<Scalar>& before, const Curve<Scalar>& after) const;
  void link(std::uint32_t first_raw);
  std::uint32_t add_node(const Vector& place);

  OffsetSpace<Scalar> space_;
  Scalar distance_;
  Tolerance<Scalar> tolerance_;
  std::uint32_t element_count_ = 0;
  std::uint32_t raw_count_ = 0;
  std::uint32_t node_count_ = 0;
};

}  // namespace cnc::contour
