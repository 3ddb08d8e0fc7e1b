#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "planner/base/axes.hpp"
#include "planner/compensation/offset_chain.hpp"

namespace cnc::compensation {

/// G41, G42 and G40: a programmed path in, the path beside it out, as lines and arcs.
///
/// The first element is the entry, as in LinuxCNC: a straight line, longer than the offset, that
/// ends where the next element's offset begins, or at the corner of both. Elements are held
/// until 16 after them are known, or G40 says that none follow; each is compared with all of
/// these before it is given out, so that what cannot be cut is refused before the motion that it
/// would damage. After a fault nothing more is given out.
class Compensator {
 public:
  static constexpr std::size_t kLookAhead = OffsetChain::kLookAhead;

  /// G41, G42: from the next element on.
  /// @param here where the machine is
  /// @param offset_mm signed, positive is the right of the path (G42.1); not 0
  void begin(const Position& here, Plane plane, float offset_mm);
  /// G40: no element follows. What was held can be taken, unless there is a fault.
  [[nodiscard]] std::optional<Fault> end();
  /// Forgets everything.
  void clear();
  /// Where the programmed path has come to without compensation. @pre !active() && !beside()
  void stand_at(const Position& here) { programmed_ = here; }

  /// Between begin() and end(), or elements wait to be taken.
  [[nodiscard]] bool active() const { return active_; }
  /// After end(), until leave(): the machine is beside the programmed path.
  [[nodiscard]] bool beside() const { return beside_; }
  /// Whether put() may be called: nothing waits to be taken.
  [[nodiscard]] bool has_room() const { return given_ == free_; }
  /// Nothing is held.
  [[nodiscard]] bool empty() const { return given_ == chain_.size() || !active_; }

  /// Takes an element that moves. @pre active(), has_room(), and it begins where the programmed
  /// path has ended so far
  [[nodiscard]] std::optional<Fault> put(const path::PathItem& item);
  /// The next element to be driven; false when there is none yet.
  [[nodiscard]] bool take(path::PathItem& item);
  /// Whether a straight line from the end of the path to a place, the exit, damages nothing.
  [[nodiscard]] std::optional<Fault> leave(const Position& to);
  /// Whether it was left some other way.
  [[nodiscard]] Fault refuse_to_leave() const;

  /// Where the programmed path ends.
  [[nodiscard]] const Position& programmed() const { return programmed_; }

 private:
  [[nodiscard]] std::optional<Fault> refusal_of(const path::PathItem& item) const;
  [[nodiscard]] Place place_of(const Position& position) const;
  [[nodiscard]] std::optional<Curve> next_stretch();
  [[nodiscard]] motion::Beside side() const;
  [[nodiscard]] bool give(const Curve& way, path::PathItem& item);

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
