#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "host-sim/import/piece.hpp"

namespace sim::drawing {

/// Width of the widest gap that may be a mistake in a drawing, mm.
inline constexpr double kWidestProposedGapMm = 0.5;
/// Width of the widest gap that is certainly a mistake if no third end is near its two ends, mm. It
/// is about the width of a kerf.
inline constexpr double kWidestCertainGapMm = 0.2;
/// Width of the widest gap that may be a mistake if no third end is near its two ends, mm.
inline constexpr double kWidestDoubtfulGapMm = 0.3;

/// Ends of open chains, sorted by position. All ends must be added before neighbours are searched.
/// "The widest gap" below is kWidestProposedGapMm.
class LooseEnds {
 public:
  /// Adds an end of a chain.
  /// @param entity entity that drew the chain
  void add(const Place& place, const Entity& entity) {
    cells_.emplace_back(key_of(place, 0, 0), ends_.size());
    ends_.push_back({place, entity.layer, entity.part});
  }
  /// Adds both ends of a chain.
  void add(const Piece& chain) {
    add(chain.outline.front(), chain.contour.entity);
    add(chain.outline.back(), chain.contour.entity);
  }
  /// Prepares the search for neighbours. Must be called after the last add() and before the
  /// functions below.
  void prepare();

  [[nodiscard]] std::size_t count() const { return ends_.size(); }

  /// Pairs ends of one layer and part within the widest gap, beginning with the smallest distances.
  /// @return the distances between the ends of each pair, mm, in ascending order; each end is in at
  /// most one pair
  [[nodiscard]] std::vector<double> paired_distances() const;

  /// The neighbours of an end: the ends of its layer and part within the widest gap.
  struct Neighbours {
    std::size_t count = 0;  ///< Number of neighbours: 0, 1, or 2 for two or more.
    std::size_t first = 0;  ///< Index of one of the neighbours, in the order of `add()`.
    double apart_mm = 0.0;  ///< Distance of the neighbour `first`.
  };
  [[nodiscard]] Neighbours neighbours_of(std::size_t end) const;

  /// Returns whether each of two ends is the only neighbour of the other end. There is then
  /// probably a gap between them.
  [[nodiscard]] bool are_pair(std::size_t end, std::size_t other) const;

  /// Returns whether an end has exactly one neighbour, forms a pair with it by are_pair(), and is
  /// at most `max_mm` away from it.
  [[nodiscard]] bool is_of_pair(std::size_t end, double max_mm) const;

 private:
  using Key = std::uint64_t;

  struct LooseEnd {
    Place place;
    std::size_t layer;
    std::size_t part;
  };

  [[nodiscard]] static Key key_of(const Place& place, int dx, int dy);
  /// Calls `visit(other, apart)` for each neighbour of `end`, with its index and distance, until a
  /// call returns false.
  template <typename Visit>
  void visit_near(std::size_t end, const Visit& visit) const;

  std::vector<LooseEnd> ends_;
  /// Each end with the key of its cell, sorted by cell.
  std::vector<std::pair<Key, std::size_t>> cells_;
};

}  // namespace sim::drawing
