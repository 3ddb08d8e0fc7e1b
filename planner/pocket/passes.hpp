#pragma once

#include <cstddef>
#include <cstdint>

#include "planner/contour/offset_space.hpp"
#include "planner/pocket/area_list.hpp"

namespace cnc::pocket {

/// What is known of a pass besides its loops.
template <typename Scalar>
struct PassNote {
  Scalar distance{};  ///< From the wall, mm: of the pass with its corners not rounded.
  std::uint32_t parent = contour::kNone;  ///< The pass around it; kNone for a pass at the wall.
};

/// Passes of a pocket in storage of the caller. Each is the boundary of a connected area, so that
/// it has one loop outside and one around each island. A pass comes after the one around it.
template <typename Scalar>
class PassList {
 public:
  PassList(const AreaList<Scalar>& areas, contour::Slice<PassNote<Scalar>> notes)
      : areas_{areas}, notes_{notes} {}

  void clear() { areas_.clear(); }
  [[nodiscard]] std::size_t size() const { return areas_.size(); }
  [[nodiscard]] contour::ContourView<Scalar> loops(std::size_t pass) const { return areas_[pass]; }
  [[nodiscard]] const PassNote<Scalar>& note(std::size_t pass) const { return notes_[pass]; }

  /// Appends a pass. False when the storage is full; the list is of no use then.
  [[nodiscard]] bool add(const contour::ContourView<Scalar>& loops, const PassNote<Scalar>& note) {
    if (areas_.size() == notes_.size() || !areas_.begin_area()) return false;
    notes_[areas_.size() - 1] = note;
    for (std::size_t loop = 0; loop < loops.loop_ends.size(); ++loop) {
      if (!areas_.add_loop(loops, loop)) return false;
    }
    return true;
  }

 private:
  AreaList<Scalar> areas_;
  contour::Slice<PassNote<Scalar>> notes_;
};

}  // namespace cnc::pocket
