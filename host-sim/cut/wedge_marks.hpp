#pragma once

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "host-sim/cut/clearance.hpp"
#include "host-sim/cut/stroke.hpp"

namespace sim::cut {

/// A point on one of the paths around outlines.
struct PathMark {
  std::size_t loop = 0;
  double way_mm = 0.0;  ///< Distance along the path to the point.
  Place place{0.0, 0.0};
};

/// A stretch of an outline that touches no other outline, between two nodes at which it does.
struct FreeStretch {
  std::size_t contour = 0;
  std::size_t from = 0;      ///< Number of the node at the start of the stretch.
  std::size_t to = 0;        ///< Number of the node at the end of the stretch.
  Place leaving{0.0, 0.0};   ///< Unit direction in which the stretch leaves the first node.
  Place arriving{0.0, 0.0};  ///< Unit direction in which the stretch arrives at the last node.
  double length_mm = 0.0;
  /// Point of a path to which the line from the first node leads through the waste.
  std::optional<PathMark> first{};
  /// Point of a path to which the line from the last node leads through the waste.
  std::optional<PathMark> last{};
};

/// Greatest length of a line from a node through the waste, in half kerfs.
inline constexpr double kLongestConnector = 4.0;

/// Finds straight lines from nodes through the waste to the paths around outlines.
class WedgeMarks {
 public:
  /// Makes an object that searches for lines from `nodes`.
  /// @param rows closed paths at half a kerf around all outlines
  /// @param near all outlines, with a reach of at least kLongestConnector half kerfs
  WedgeMarks(const std::vector<Place>& nodes,
             const std::vector<MeasuredRow>& rows,
             const Clearance& near,
             double half_kerf_mm);

  /// Sets `first` and `last` of free stretches. At a node, the waste between an arriving stretch
  /// and the next leaving stretch to the left is a wedge. Both stretches get the same mark: the
  /// point of the paths in this wedge that is nearest to the node. They get no mark if the waste is
  /// too narrow for a path.
  void find(std::vector<FreeStretch>& stretches) const;

 private:
  /// The waste at a node between two free stretches.
  struct Wedge {
    std::size_t node = 0;
    Place from{0.0, 0.0};  ///< Unit direction of the right side of the wedge.
    double angle = 0.0;    ///< Angle from the right side to the left side, above 0.
    bool is_only = false;  ///< Whether the node has no other wedge.
  };
  struct Ends {
    std::vector<std::size_t> arriving{};
    std::vector<std::size_t> leaving{};
  };

  void mark_wedges(std::size_t node, const Ends& ends, std::vector<FreeStretch>& stretches) const;
  [[nodiscard]] std::optional<PathMark> mark_in(const Wedge& wedge) const;
  [[nodiscard]] bool leads_through_waste(const Place& from, const Place& to) const;
  [[nodiscard]] PathMark mark_on(std::size_t number, const Place& place) const;

  const std::vector<Place>& nodes_;
  const std::vector<MeasuredRow>& rows_;
  const Clearance& near_;
  double half_;
  Clearance strokes_;
  /// For each stroke, its path and its number in this path.
  std::vector<std::pair<std::size_t, std::size_t>> owners_;
};

}  // namespace sim::cut
