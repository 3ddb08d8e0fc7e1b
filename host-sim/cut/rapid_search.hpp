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

/// The search for one way round areas, from corner to corner of those that were met (A*).
///
/// A leg is tried when it is the most promising one; what keeps it from being driven adds its
/// corners to the places that can be reached from there. So a way costs the areas along it, not
/// all that there are. It is nearly the shortest: estimates are raised by some per cent, more
/// where the search is long.
class RapidSearch {
 public:
  /// @param legs what is free; it and the ends must outlive the search
  /// @param lowest corners below or left of it are not used
  RapidSearch(const FreeLegs& legs, const RapidEnd& from, const RapidEnd& to, const Place& lowest);

  enum class Outcome : std::uint8_t {
    kFound,
    kNoWay,   ///< All that can be reached was tried.
    kGaveUp,  ///< More trials may find one.
  };

  /// Searches, or goes on with a search that was given up. @pre the ends are in no area
  /// @param max_trials legs that are tried, in all
  [[nodiscard]] Outcome find(std::uint64_t max_trials);

  /// Returns all places of the way, the ends included. @pre it was found
  [[nodiscard]] std::vector<Place> way() const;

  /// Returns whether a corner was left out because it is too far left or low.
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
    std::uint64_t number = 0;  ///< Of equal ones the older comes first.
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
