#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "planner/base/axes.hpp"
#include "planner/compensation/offset_chain.hpp"

namespace cnc::compensation {

/// Returns whether an element moves an axis of a plane.
[[nodiscard]] bool moves_in(Plane plane, const PathElement& element);

/// Cutter compensation (G41, G42 and G40): takes a programmed path and returns the path at an
/// offset from it, as lines and arcs.
///
/// The first element is the entry, as in LinuxCNC. It is a line or an arc that is longer than the
/// offset. It leads to the start of the next element's offset or, if both offsets intersect, to
/// their intersection.
/// An element is held until 16 elements after it are known, or until G40 reports that no element
/// follows. Before an element is given out, its offset is compared with all edges among the known
/// elements. So a path that cannot be cut is refused before the motion that would damage the part.
/// After a fault no further element is given out. Elements of leads do not count as edges
/// (HeldPath).
///
/// Axes outside the plane move along the offset of their element. An element that moves no axis of
/// the plane is driven at the present end of the offset path.
class Compensator {
 public:
  static constexpr std::size_t kLookAhead = HeldPath::kLookAhead;
  /// Greatest number of consecutive elements that move no axis of the plane.
  static constexpr std::size_t kMaxStanding = 8;

  /// Begins compensation with the next element (G41, G42).
  /// @param here machine position
  /// @param offset_mm signed offset, positive is to the right of the path (G42.1); not 0
  void begin(const Position& here, Plane plane, float offset_mm);
  /// Ends the path (G40): no element follows. Unless there is a fault, the held elements can then
  /// be taken.
  [[nodiscard]] std::optional<Fault> end();
  /// Ends compensation and forgets all elements.
  void clear();
  /// Sets the end of the programmed path after motions without compensation. If beside(), these
  /// motions have moved only axes outside the plane. @pre !active()
  void stand_at(const Position& here);

  /// Returns whether a path has begun and not ended, or elements wait to be taken.
  [[nodiscard]] bool active() const { return active_; }
  /// Returns whether the path has ended, but the machine is still offset from it: from end() until
  /// leave().
  [[nodiscard]] bool beside() const { return beside_; }
  /// Returns whether put() may be called: no element waits to be taken.
  [[nodiscard]] bool has_room() const { return given_ == free_; }
  /// Returns whether no element is held.
  [[nodiscard]] bool empty() const { return given_ == chain_.size() || !active_; }

  /// Accepts an element that moves. @pre active(), has_room(), the element begins at programmed(),
  /// and the first element moves in the plane
  [[nodiscard]] std::optional<Fault> put(const path::PathItem& item);
  /// Sets `item` to the next element to be driven. Returns false if there is no such element yet.
  [[nodiscard]] bool take(path::PathItem& item);
  /// Begins the exit from the path: a straight line to the point `to`. Returns a fault if the exit
  /// would cut into the part. If the exit first goes around the corner at the end of the path,
  /// take() then returns that arc. @pre beside()
  /// @param rapid the exit is a rapid, which cuts nothing below its path
  [[nodiscard]] std::optional<Fault> leave(const Position& to, bool rapid);
  /// Returns the fault for a motion that leaves the path but is not a straight line in the plane.
  [[nodiscard]] Fault refuse_to_leave() const;

  /// Returns the end of the programmed path.
  [[nodiscard]] const Position& programmed() const { return programmed_; }
  /// Returns the end of the path that was given out.
  [[nodiscard]] const Position& driven() const { return driven_; }
  [[nodiscard]] Plane plane() const { return plane_; }

 private:
  [[nodiscard]] std::optional<Fault> refusal_of(const path::PathItem& item, float chord_mm) const;
  [[nodiscard]] motion::Beside side() const;
  [[nodiscard]] bool give(const HeldElement& held, Kind kind, path::PathItem& item);
  void lead_along(const Curve& curve, PathElement& way) const;

  OffsetChain chain_{};
  Position programmed_{};
  Position driven_{};  ///< End of the path that was given out.
  motion::OutputChanges outputs_{};
  Plane plane_ = Plane::kXY;
  bool active_ = false;
  bool beside_ = false;
  bool ended_ = false;
  std::size_t free_ = 0;   ///< Number of elements that may be given out.
  std::size_t given_ = 0;  ///< Number of elements that have been given out completely.
  std::size_t kind_ = 0;   ///< Number of raw curves of the next element that have been given out.
};

}  // namespace cnc::compensation
