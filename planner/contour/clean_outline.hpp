#pragma once

#include "planner/contour/contour.hpp"
#include "planner/contour/offset_space.hpp"

namespace cnc::contour {

/// One loop in a form that can be offset. Elements shorter than `touch` are removed. An arc of more
/// than half a turn becomes two arcs. A path out and back on the same line or arc is removed, too,
/// because it encloses nothing.
template <typename Scalar>
class CleanOutline {
 public:
  CleanOutline(Slice<Vertex<Scalar>> storage, Scalar touch) : kept_{storage}, touch_{touch} {}

  /// Reads one loop. Returns false if the storage is full.
  [[nodiscard]] bool read(const ContourView<Scalar>& contour, std::size_t loop);

  /// Returns the number of elements after read(); 0 if the loop encloses nothing.
  [[nodiscard]] std::uint32_t count() const { return end_ - begin_; }
  /// Returns element `index`, or an error if its two ends are one point. @pre index < count()
  [[nodiscard]] Result<BasicArc<Scalar>, ArcError> element(std::uint32_t index) const;

 private:
  using Vector = BasicVec2<Scalar>;

  [[nodiscard]] bool add(const Vector& start, const Vector& end, Scalar bulge);
  [[nodiscard]] bool add_half(const Vector& start, const Vector& end, Scalar bulge);
  [[nodiscard]] bool turns_back(const Vector& start,
                                const Vector& corner,
                                const Vector& end,
                                Scalar bulge_in,
                                Scalar bulge_out) const;
  void close();

  Slice<Vertex<Scalar>> kept_;
  Scalar touch_;
  std::uint32_t begin_ = 0;
  std::uint32_t end_ = 0;
  Vector place_{Scalar{0}, Scalar{0}};  ///< End of the last element.
};

}  // namespace cnc::contour
