#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "host-sim/import/extent.hpp"
#include "host-sim/import/piece.hpp"

namespace sim::drawing {

/// One end of a chain: its start (even) or its end (odd).
using EndIndex = std::size_t;
inline constexpr EndIndex kNoEnd = static_cast<EndIndex>(-1);

/// Ends nearer than this are one place: the controller's own resolution, mm.
inline constexpr double kSamePlaceMm = 1.0e-6;

/// Gaps that are joined although they are wider than asked.
struct CertainGaps {
  std::size_t count = 0;
  Extent widest{};  ///< mm.
};

/// Pairs the ends of chains that are near each other, the nearest first.
class EndMatcher {
 public:
  /// @param chains must outlive this
  EndMatcher(const std::vector<Piece>& chains, double gap_mm);

  /// Pairs ends that are farther apart, up to kWidestCertainGapMm, and have no other one near.
  CertainGaps pair_certain();

  /// Returns the end that meets an end, or kNoEnd.
  [[nodiscard]] EndIndex partner(EndIndex end) const { return partner_[end]; }
  [[nodiscard]] Place place(EndIndex end) const {
    const std::vector<Place>& outline = chains_[end / 2].outline;
    return end % 2 == 0 ? outline.front() : outline.back();
  }
  /// Returns whether an end that has no partner is near others that have.
  [[nodiscard]] bool among_others(EndIndex end) const { return among_others_[end]; }

 private:
  using Key = std::uint64_t;

  struct EndPair {
    double distance_mm;
    EndIndex first;
    EndIndex second;
    auto operator<=>(const EndPair&) const = default;
  };

  [[nodiscard]] Key key_of(const Place& place, int dx, int dy) const;
  void gather_pairs();
  void gather_in(EndIndex end, Key key);
  [[nodiscard]] bool same_layer(EndIndex a, EndIndex b) const;

  const std::vector<Piece>& chains_;
  double gap_;
  std::vector<EndIndex> partner_;
  std::vector<bool> among_others_;
  std::vector<EndPair> pairs_;
  std::vector<std::pair<Key, EndIndex>> cells_;  ///< Sorted.
};

}  // namespace sim::drawing
