#pragma once

#include <cstdint>
#include <optional>
#include <queue>
#include <set>
#include <unordered_map>
#include <utility>
#include <vector>

#include "host-sim/cut/area_corners.hpp"
#include "host-sim/cut/free_leg.hpp"

namespace sim::cut {

/// The search for one path around areas (A*). The path goes from corner to corner of the areas that
/// block it.
///
/// The leg with the lowest estimate is tried first. If an area blocks the leg, its corners are
/// added to the points that can be reached from the start of the leg. So the work depends on the
/// areas along the path, not on all areas. The path is nearly the shortest one: estimates are
/// raised by some per cent, and by more in a long search.
class RapidSearch {
 public:
  /// Makes a search that has not begun.
  /// @param legs decides which legs are free; `legs` and the ends must outlive the search
  /// @param lowest corners below this point, or to the left of it, are not used
  RapidSearch(const FreeLegs& legs, const RapidEnd& from, const RapidEnd& to, const Place& lowest);

  enum class Outcome : std::uint8_t {
    kFound,
    kNoWay,   ///< All points that can be reached were tried.
    kGaveUp,  ///< The number of trials was reached; more trials may find a path.
  };

  /// Searches, or continues a search that gave up.
  /// @pre the ends are in no area
  /// @param max_trials total number of legs that may be tried in all calls
  [[nodiscard]] Outcome find(std::uint64_t max_trials);

  /// Returns all points of the path, including its ends.
  /// @pre find() returned kFound
  [[nodiscard]] std::vector<Place> way() const;

  /// Returns whether a corner was left out because it is to the left of `lowest` or below it.
  [[nodiscard]] bool was_bounded() const { return was_bounded_; }

 private:
  enum class State : std::uint8_t { kUnknown, kFree, kCovered };
  struct Node {
    AreaCorner corner{};
    bool is_corner = false;
    State state = State::kUnknown;
    bool is_reached = false;
    std::uint32_t covered_by = 0;
    std::size_t parent = 0;
    double way_mm = 0.0;
  };
  /// A leg that may be tried.
  struct Trial {
    double estimate_mm = 0.0;
    /// Number of the trial. Among trials with equal estimates, the trial with the lowest number is
    /// first.
    std::uint64_t number = 0;
    std::size_t from = 0;
    std::size_t to = 0;
    bool operator>(const Trial& other) const {
      if (estimate_mm != other.estimate_mm) return estimate_mm > other.estimate_mm;
      return number > other.number;
    }
  };

  static constexpr std::size_t kFrom = 0;
  static constexpr std::size_t kTo = 1;

  void push(std::size_t from, std::size_t to);
  void try_leg(const Trial& trial);
  void reach(std::size_t node, std::size_t parent);
  void add_corners_of(std::uint32_t area, std::size_t seen_from);
  [[nodiscard]] const std::vector<std::size_t>& nodes_of(std::uint32_t area);
  [[nodiscard]] bool is_free(Node& node);
  [[nodiscard]] std::optional<std::uint32_t> blocker(std::size_t from, std::size_t to) const;

  const FreeLegs* legs_;
  const RapidEnd* from_;
  const RapidEnd* to_;
  Place lowest_;
  std::vector<Node> nodes_;
  std::unordered_map<std::uint32_t, std::vector<std::size_t>> corners_;
  std::set<std::pair<std::size_t, std::uint32_t>> shown_;
  std::priority_queue<Trial, std::vector<Trial>, std::greater<>> trials_;
  std::uint64_t pushed_ = 0;
  std::uint64_t tried_ = 0;
  bool was_bounded_ = false;
};

}  // namespace sim::cut
