#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "host-sim/import/extent.hpp"
#include "host-sim/import/piece.hpp"

namespace sim::drawing {

/// Number of an end of a chain: even for the start, odd for the end.
using EndIndex = std::size_t;
inline constexpr EndIndex kNoEnd = static_cast<EndIndex>(-1);

/// Ends nearer than this count as one point, mm. It is the controller's own resolution.
inline constexpr double kSamePlaceMm = 1.0e-6;

/// Gaps that are joined although they are wider than the wanted gap.
struct CertainGaps {
  std::size_t count = 0;
  Extent widest{};  ///< The widest of these gaps, mm.
};

/// Pairs the ends of chains that are near each other. The nearest ends are paired first.
class EndMatcher {
 public:
  /// @param chains must outlive the matcher
  EndMatcher(const std::vector<Piece>& chains, double gap_mm);

  /// Pairs ends that are farther apart than the gap, up to kWidestCertainGapMm, if no other end is
  /// near.
  CertainGaps pair_certain();

  /// Returns the partner of an end, or kNoEnd.
  [[nodiscard]] EndIndex partner(EndIndex end) const { return partner_[end]; }
  [[nodiscard]] Place place(EndIndex end) const {
    const std::vector<Place>& outline = chains_[end / 2].outline;
    return end % 2 == 0 ? outline.front() : outline.back();
  }
  /// Returns whether an end without a partner is near ends that have partners.
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
  std::vector<std::pair<Key, EndIndex>> cells_;  ///< Ends by cell, sorted.
};

}  // namespace sim::drawing
