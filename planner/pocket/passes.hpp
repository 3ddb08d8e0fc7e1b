#pragma once

#include <cstddef>
#include <cstdint>

#include "planner/contour/offset_space.hpp"
#include "planner/pocket/area_list.hpp"

namespace cnc::pocket {

/// Data of a pass in addition to its loops.
template <typename Scalar>
struct PassNote {
  Scalar distance{};  ///< Distance of the pass from the wall before its corners were rounded, mm.
  /// Index of the pass around this pass; kNone for a pass at the wall.
  std::uint32_t parent = contour::kNone;
};

/// Passes of a pocket in storage that the caller owns. Each pass is the boundary of a connected
/// area: it has one outer loop and one loop around each island. A pass comes after the pass around
/// it.
template <typename Scalar>
class PassList {
 public:
  PassList(const AreaList<Scalar>& areas, contour::Slice<PassNote<Scalar>> notes)
      : areas_{areas}, notes_{notes} {}

  void clear() { areas_.clear(); }
  [[nodiscard]] std::size_t size() const { return areas_.size(); }
  [[nodiscard]] contour::ContourView<Scalar> loops(std::size_t pass) const { return areas_[pass]; }
  [[nodiscard]] const PassNote<Scalar>& note(std::size_t pass) const { return notes_[pass]; }

  /// Appends a pass. Returns false if the storage is full; then the list is unusable.
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
