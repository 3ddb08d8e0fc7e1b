#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "host-sim/import/extent.hpp"
#include "host-sim/import/piece.hpp"

namespace sim::drawing {

/// Number of an end of a chain: 2 i for the start of chain i, 2 i + 1 for its end.
using EndIndex = std::size_t;
inline constexpr EndIndex kNoEnd = static_cast<EndIndex>(-1);

/// Distance up to which two ends count as one point, mm. It is the resolution of the controller.
inline constexpr double kSamePlaceMm = 1.0e-6;

/// Gaps that are joined, although they are wider than the gap that the user allows.
struct CertainGaps {
  std::size_t count = 0;
  Extent widest{};  ///< Width of the widest joined gap, mm, and its position.
};

/// Pairs ends of chains that are near each other. The pairs with the smallest distances are formed
/// first.
class EndMatcher {
 public:
  /// @param chains must outlive the matcher
  EndMatcher(const std::vector<Piece>& chains, double gap_mm);

  /// Pairs two ends that are farther apart than the gap, up to kWidestCertainGapMm, if no third end
  /// is near them.
  CertainGaps pair_certain();

  /// Returns the end with which an end is paired; kNoEnd if it has no partner.
  [[nodiscard]] EndIndex partner(EndIndex end) const { return partner_[end]; }
  [[nodiscard]] Place place(EndIndex end) const {
    const std::vector<Place>& outline = chains_[end / 2].outline;
    return end % 2 == 0 ? outline.front() : outline.back();
  }
  /// Returns whether other ends are within the gap of an end, even if all of them have other
  /// partners.
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
  /// Each end with the key of its cell, sorted by cell.
  std::vector<std::pair<Key, EndIndex>> cells_;
};

}  // namespace sim::drawing
