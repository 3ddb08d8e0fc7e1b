#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "host-sim/import/piece.hpp"

namespace sim::drawing {

/// The widest gap that may be a slip of a drawing, mm.
inline constexpr double kWidestProposedGapMm = 0.5;
/// A gap up to this, between two ends with no other one near, is a slip, mm: it is about a kerf.
inline constexpr double kWidestCertainGapMm = 0.2;
/// A gap up to this, between such ends, may be a slip, mm.
inline constexpr double kWidestDoubtfulGapMm = 0.3;

/// Ends of open chains, by place: first they are added, then asked for their neighbours.
class LooseEnds {
 public:
  /// Adds an end of a chain of an entity.
  void add(const Place& place, const Entity& entity) {
    cells_.emplace_back(key_of(place, 0, 0), ends_.size());
    ends_.push_back({place, entity.layer, entity.part});
  }
  /// Adds the start of a chain, and its end.
  void add(const Piece& chain) {
    add(chain.outline.front(), chain.contour.entity);
    add(chain.outline.back(), chain.contour.entity);
  }
  /// Call after the last end was added, and before any question.
  void prepare();

  [[nodiscard]] std::size_t count() const { return ends_.size(); }

  /// Pairs ends of one layer and part within the widest gap, the nearest first.
  /// @return the distances of the pairs, mm, not falling; each end is in one pair at most
  [[nodiscard]] std::vector<double> paired_distances() const;

  /// The ends of one layer and part that are within the widest gap of an end.
  struct Neighbours {
    std::size_t count = 0;  ///< 2 where there are more.
    std::size_t first = 0;  ///< One of them; its number, as in the order of `add()`.
    double apart_mm = 0.0;  ///< How far that one is.
  };
  [[nodiscard]] Neighbours neighbours_of(std::size_t end) const;

  /// Returns whether two ends have each other for neighbours, and no others: they may be a gap.
  [[nodiscard]] bool are_pair(std::size_t end, std::size_t other) const;

  /// Returns whether an end is one of such a pair, no farther apart than this.
  [[nodiscard]] bool is_of_pair(std::size_t end, double most_mm) const;

 private:
  using Key = std::uint64_t;

  struct LooseEnd {
    Place place;
    std::size_t layer;
    std::size_t part;
  };

  [[nodiscard]] static Key key_of(const Place& place, int dx, int dy);
  /// Calls `visit(other, apart)` for each end within the widest gap of `end`, until it is false.
  template <typename Visit>
  void visit_near(std::size_t end, const Visit& visit) const;

  std::vector<LooseEnd> ends_;
  std::vector<std::pair<Key, std::size_t>> cells_;  ///< Sorted.
};

}  // namespace sim::drawing
