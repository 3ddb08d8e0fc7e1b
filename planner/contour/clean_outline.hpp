#pragma once

#include "planner/contour/contour.hpp"
#include "planner/contour/offset_space.hpp"

namespace cnc::contour {

/// One loop, brought into a form that can be moved aside: elements shorter than
/// `touch` are gone, arcs of more than half a turn are two, and a way out and
/// back on the same line or arc, which encloses nothing, is gone, too.
template <typename Scalar>
class CleanOutline {
 public:
  CleanOutline(Slice<Vertex<Scalar>> storage, Scalar touch) : kept_{storage}, touch_{touch} {}

  /// False when the storage is full.
  [[nodiscard]] bool read(const ContourView<Scalar>& contour, std::size_t loop);

  /// Elements after `read`; none when the loop encloses nothing.
  [[nodiscard]] std::uint32_t count() const { return end_ - begin_; }
  /// Fails where both ends are one place after all. @pre index < count()
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
  Vector place_{Scalar{0}, Scalar{0}};  ///< Where the last element ends.
};

}  // namespace cnc::contour
