#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "planner/base/axes.hpp"
#include "planner/compensation/offset_chain.hpp"

namespace cnc::compensation {

/// Whether an element moves an axis of a plane.
[[nodiscard]] bool moves_in(Plane plane, const PathElement& element);

/// G41, G42 and G40: a programmed path in, the path beside it out, as lines and arcs.
///
/// The first element is the entry, as in LinuxCNC: a line or an arc, longer than the offset, that
/// ends where the next element's offset begins, or at the corner of both. Elements are held
/// until 16 after them are known, or G40 says that none follow; each is compared with the edges
/// among these before it is given out, so that what cannot be cut is refused before the motion that
/// it would damage. After a fault nothing more is given out. Leads are no edges (HeldPath).
///
/// Other axes move along the offset of their element; an element that moves no axis of the plane
/// is driven where the offset path is at that point.
class Compensator {
 public:
  static constexpr std::size_t kLookAhead = HeldPath::kLookAhead;
  /// Elements in a row that move no axis of the plane.
  static constexpr std::size_t kMostStanding = 8;

  /// G41, G42: from the next element on.
  /// @param here where the machine is
  /// @param offset_mm signed, positive is the right of the path (G42.1); not 0
  void begin(const Position& here, Plane plane, float offset_mm);
  /// G40: no element follows. What was held can be taken, unless there is a fault.
  [[nodiscard]] std::optional<Fault> end();
  /// Forgets everything.
  void clear();
  /// Where the programmed path has come to without compensation. Where beside(), the machine has
  /// moved other axes than those of the plane. @pre !active()
  void stand_at(const Position& here);

  /// Between begin() and end(), or elements wait to be taken.
  [[nodiscard]] bool active() const { return active_; }
  /// After end(), until leave(): the machine is beside the programmed path.
  [[nodiscard]] bool beside() const { return beside_; }
  /// Whether put() may be called: nothing waits to be taken.
  [[nodiscard]] bool has_room() const { return given_ == free_; }
  /// Nothing is held.
  [[nodiscard]] bool empty() const { return given_ == chain_.size() || !active_; }

  /// Takes an element that moves. @pre active(), has_room(), it begins where the programmed path
  /// has ended so far, and the first one moves in the plane
  [[nodiscard]] std::optional<Fault> put(const path::PathItem& item);
  /// The next element to be driven; false when there is none yet.
  [[nodiscard]] bool take(path::PathItem& item);
  /// Whether a straight line from the end of the path to a point, the exit, damages nothing. Where
  /// it goes round the corner at the end first, that arc can be taken. @pre beside()
  /// @param rapid it cuts nothing that is below it
  [[nodiscard]] std::optional<Fault> leave(const Position& to, bool rapid);
  /// Whether it was left some other way.
  [[nodiscard]] Fault refuse_to_leave() const;

  /// Where the programmed path ends.
  [[nodiscard]] const Position& programmed() const { return programmed_; }
  /// Where the path that was given out ends.
  [[nodiscard]] const Position& driven() const { return driven_; }
  [[nodiscard]] Plane plane() const { return plane_; }

 private:
  [[nodiscard]] std::optional<Fault> refusal_of(const path::PathItem& item, float chord_mm) const;
  [[nodiscard]] motion::Beside side() const;
  [[nodiscard]] bool give(const HeldElement& held, Kind kind, path::PathItem& item);
  void lead_along(const Curve& curve, PathElement& way) const;

  OffsetChain chain_{};
  Position programmed_{};
  Position driven_{};  ///< Where the path that was given out ends.
  motion::OutputChanges outputs_{};
  Plane plane_ = Plane::kXY;
  bool active_ = false;
  bool beside_ = false;
  bool ended_ = false;
  std::size_t free_ = 0;   ///< So many elements may be given out…
  std::size_t given_ = 0;  ///< …and so many have been, but for…
  std::size_t kind_ = 0;   ///< …so many raw curves of the next.
};

}  // namespace cnc::compensation
