#pragma once

#include <array>
#include <optional>

#include "planner/pocket/loop_place.hpp"
#include "planner/pocket/nearest_curve.hpp"

namespace cnc::pocket {

/// A path from a pose to a point on a loop: an arc, a line and an arc. Their tangents agree at
/// every joint. Each arc turns by at most half a turn. Each of the three parts may have the length
/// 0.
template <typename Scalar>
struct Link {
  std::array<BasicVec2<Scalar>, 4> points{};
  std::array<Scalar, 3> bulges{};
  Scalar length{};  ///< mm.
  LoopPlace<Scalar> landing;
};

/// Finds links between passes, within the area in which the tool's centre may be.
template <typename Scalar>
class LinkSearch {
 public:
  /// Stores references to working storage: one curve for each element of an area, and
  /// BoxTree::size_for() boxes.
  LinkSearch(contour::Slice<contour::Curve<Scalar>> curves,
             contour::Slice<contour::FlatBox<Scalar>> boxes)
      : boundary_{curves, boxes} {}

  /// Sets the area that links must not leave. Returns false if the storage is full.
  /// @pre `area` outlives all later calls of find()
  [[nodiscard]] bool enter(const contour::ContourView<Scalar>& area) {
    area_ = area;
    return boundary_.read(area);
  }

  /// Returns a link to one of the loops; nothing if there is no link of up to 12 tool radii.
  ///
  /// A landing is the point of a loop where a link ends. The landings that are tried are the middle
  /// of each element, and points half a tool radius apart on both sides of the nearest point of the
  /// element, up to three radii away. The result is the shortest link that stays in the area. Its
  /// arcs have the tool's radius, or the first of 1/2, 1/4 and 1/10 of this radius with which there
  /// is a link. The last arc turns to the side of the area, so that the tool arrives from inside.
  ///
  /// Guarantee: no point of the link is outside the area by more than 1e-7 mm. Time: number of
  /// elements within six radii times the number of links that are tried, at most 64.
  /// @param left_out  for each loop of the area, whether links must not lead to it; an empty slice
  ///     excludes no loop
  /// @pre 0 < tool_radius
  [[nodiscard]] std::optional<Link<Scalar>> find(const Pose<Scalar>& from,
                                                 contour::Slice<const bool> left_out,
                                                 Milling milling,
                                                 Scalar tool_radius) const;

 private:
  using Vector = BasicVec2<Scalar>;

  /// Parameters of one search.
  struct Wanted {
    Pose<Scalar> from;
    contour::Slice<const bool> left_out;
    Milling milling = Milling::kClimb;
    Scalar tool_radius{};
    Scalar arc_radius{};
  };

  [[nodiscard]] std::optional<Link<Scalar>> shortest_beyond(const Wanted& wanted,
                                                            Scalar length) const;
  [[nodiscard]] std::size_t loop_of(std::uint32_t vertex) const;
  void try_element(const Wanted& wanted,
                   std::uint32_t vertex,
                   Scalar beyond,
                   std::optional<Link<Scalar>>& best) const;
  void try_landing(const Wanted& wanted,
                   const LoopPlace<Scalar>& landing,
                   Scalar beyond,
                   std::optional<Link<Scalar>>& best) const;
  [[nodiscard]] bool stays_inside(const Link<Scalar>& link) const;
  [[nodiscard]] bool crosses(const contour::Curve<Scalar>& part, const Link<Scalar>& link) const;

  contour::ContourView<Scalar> area_{};
  NearestCurve<Scalar> boundary_;
};

}  // namespace cnc::pocket
