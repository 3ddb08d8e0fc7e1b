#include "host-sim/cut/fill_chains.hpp"

#include <algorithm>
#include <cstddef>
#include <memory>
#include <optional>
#include <unordered_map>
#include <utility>

#include "host-sim/cut/clearance.hpp"
#include "host-sim/cut/segment_distance.hpp"

namespace sim::cut {
namespace {

/// Greatest distance from the end of a path to the row along which it continues, in intervals.
constexpr double kLongestLink = 2.0;
/// Greatest distance between the beginning of a spur (see FillRest::is_spur) and the corner of a
/// row, in intervals.
constexpr double kCornerReach = 0.2;
/// Greatest length of the path with the beam off to the start of a detour, in intervals.
constexpr double kLongestReturn = 3.0;
/// Greatest length of a spur, in intervals. A longer spur becomes a separate path.
constexpr double kLongestSpur = 2.0;

/// The rows of one level. Their strokes have consecutive numbers, also from row to row.
class Level {
 public:
  Level(FillRows rows, double interval_mm)
      : rows_{std::move(rows)}, near_{kLongestLink * interval_mm} {
    std::size_t number = 0;
    for (const std::vector<Stroke>& row : rows_) {
      firsts_.push_back(number);
      for (const Stroke& stroke : row) near_.add(stroke, number++);
    }
    near_.prepare();
  }

  /// A point on a stroke of a row.
  struct On {
    std::size_t row = 0;
    std::size_t stroke = 0;
    Place place{0.0, 0.0};
  };

  [[nodiscard]] std::size_t size() const { return rows_.size(); }
  [[nodiscard]] On begin_of(std::size_t row) const { return {row, 0, rows_[row].front().from}; }

  /// Returns the point on the rows that is nearest to `place`; nothing if none is within reach.
  [[nodiscard]] std::optional<On> nearest(const Place& place) const {
    const Clearance::Nearest found = near_.nearest(place);
    if (found.stroke == nullptr) return std::nullopt;
    const auto after = std::ranges::upper_bound(firsts_, found.owner);
    const auto row = static_cast<std::size_t>(after - firsts_.begin()) - 1;
    return On{row, found.owner - firsts_[row], nearest_on(*found.stroke, place)};
  }

  /// Adds a spur to the level if it begins near a corner of a row. Returns whether it was added.
  [[nodiscard]] bool take_spur(const FillRest& spur, double reach_mm) {
    const std::optional<On> on = nearest(spur.places.front());
    if (!on) return false;
    const std::vector<Stroke>& row = rows_[on->row];
    const std::size_t next = on->stroke + 1 < row.size() ? on->stroke + 1 : 0;
    const double to_this = drawing::distance(row[on->stroke].from, spur.places.front());
    const double to_next = drawing::distance(row[next].from, spur.places.front());
    if (std::min(to_this, to_next) > reach_mm) return false;
    const std::size_t corner = to_this <= to_next ? on->stroke : next;
    spurs_[firsts_[on->row] + corner].push_back(spur.places);
    return true;
  }

  /// A path that ends near a row and is driven as a detour from this row. At the target point on
  /// the row, the beam leaves the row, goes to the start of the path, and follows the path back to
  /// the target point.
  struct Detour {
    On target{};
    std::vector<Stroke> path{};
  };

  /// Appends a whole row, from the point `from` once around, with the detours from the row.
  void drive(const On& from, const std::vector<Detour>& detours, std::vector<Stroke>& path) {
    const std::size_t count = rows_[from.row].size();
    std::vector<Stop> stops;
    stops.reserve(detours.size());
    for (const Detour& detour : detours) {
      stops.push_back({detour.target.stroke, share_of(detour.target), &detour});
    }
    std::ranges::stable_sort(stops, [](const Stop& a, const Stop& b) {
      return a.stroke != b.stroke ? a.stroke < b.stroke : a.share < b.share;
    });
    const double share = share_of(from);
    drive_part({from.row, from.stroke}, share, 1.0, stops, path);
    for (std::size_t i = 1; i < count; ++i) {
      drive_part({from.row, (from.stroke + i) % count}, 0.0, 1.0, stops, path);
    }
    if (share > 0.0) drive_part({from.row, from.stroke}, 0.0, share, stops, path);
  }

 private:
  /// A point of a row from which a detour starts.
  struct Stop {
    std::size_t stroke = 0;
    double share = 0.0;
    const Detour* detour = nullptr;
  };

  /// Returns the position of a point on its stroke, as a share of the length of the stroke. A share
  /// near 0 or 1 becomes exactly 0 or 1.
  [[nodiscard]] double share_of(const On& on) const {
    constexpr double kAtEnd = 1.0e-9;
    const double share = nearest_share(rows_[on.row][on.stroke], on.place);
    if (share < kAtEnd) return 0.0;
    return share > 1.0 - kAtEnd ? 1.0 : share;
  }

  /// Appends a part of a stroke, with the spurs at the start of the stroke and the detours from the
  /// part.
  void drive_part(const On& on,
                  double from,
                  double to,
                  const std::vector<Stop>& stops,
                  std::vector<Stroke>& path) const {
    const Stroke& stroke = rows_[on.row][on.stroke];
    if (from == 0.0) drive_spurs(firsts_[on.row] + on.stroke, stroke.from, path);
    const auto go_to = [&](double share) {
      if (share <= from) return;
      const bool is_whole = from == 0.0 && share == 1.0;
      path.push_back(is_whole ? stroke : part_of(stroke, from, share));
      from = share;
    };
    const auto first = std::ranges::lower_bound(stops, on.stroke, {}, &Stop::stroke);
    for (auto stop = first; stop != stops.end() && stop->stroke == on.stroke; ++stop) {
      if (stop->share < from || stop->share > to || (stop->share == from && from > 0.0)) continue;
      go_to(stop->share);
      drive_detour(*stop->detour, place_at(stroke, stop->share), path);
    }
    go_to(to);
  }

  static void drive_detour(const Detour& detour, const Place& place, std::vector<Stroke>& path) {
    const std::vector<Stroke>& strokes = detour.path;
    if (place != strokes.front().from) {
      path.push_back({place, strokes.front().from, 0.0, Purpose::kOverscan});
    }
    path.insert(path.end(), strokes.begin(), strokes.end());
    if (strokes.back().to != place) path.push_back({strokes.back().to, place});
  }

  void drive_spurs(std::size_t number, const Place& corner, std::vector<Stroke>& path) const {
    const auto found = spurs_.find(number);
    if (found == spurs_.end()) return;
    for (const std::vector<Place>& spur : found->second) {
      Place here = corner;
      for (std::size_t i = 1; i < spur.size(); ++i) {
        if (here != spur[i]) path.push_back({here, spur[i]});
        here = spur[i];
      }
      if (here != corner) path.push_back({here, corner, 0.0, Purpose::kOverscan});
    }
  }

  FillRows rows_;
  std::vector<std::size_t> firsts_;  ///< Number of the first stroke of each row.
  Clearance near_;
  /// Spurs, by the number of the stroke that begins at the corner of the spur.
  std::unordered_map<std::size_t, std::vector<std::vector<Place>>> spurs_;
};

double length_of(const std::vector<Place>& places) {
  double length = 0.0;
  for (std::size_t i = 1; i < places.size(); ++i) {
    length += drawing::distance(places[i - 1], places[i]);
  }
  return length;
}

class ChainMaker {
 public:
  ChainMaker(std::vector<FillRows> rows, double interval_mm) : interval_{interval_mm} {
    for (FillRows& level : rows) {
      levels_.push_back(std::make_unique<Level>(std::move(level), interval_mm));
    }
  }

  std::vector<std::vector<Stroke>> make(const std::vector<FillRest>& rests) {
    std::vector<std::vector<const FillRest*>> lines(levels_.size() + 1);
    for (const FillRest& rest : rests) {
      const std::size_t level = std::min(rest.level, levels_.size());
      const bool is_short = rest.is_spur && length_of(rest.places) <= kLongestSpur * interval_;
      const bool is_taken = is_short && level < levels_.size() &&
                            levels_[level]->take_spur(rest, kCornerReach * interval_);
      if (!is_taken) lines[level].push_back(&rest);
    }
    for (std::size_t level = levels_.size() + 1; level-- > 0;) {
      if (level < levels_.size()) drive_level(level);
      // The lines of this level follow, because they are between this level and the next level
      // outside.
      for (const FillRest* line : lines[level]) drive_line(*line, level);
    }
    return std::move(paths_);
  }

 private:
  /// Drives all rows of a level. A path that ended next to a row of this level continues along the
  /// row.
  void drive_level(std::size_t number) {
    Level& level = *levels_[number];
    std::vector<std::vector<Level::Detour>> arriving(level.size());
    for (Level::Detour& path : std::exchange(open_, {})) {
      arriving[path.target.row].push_back(std::move(path));
    }
    for (std::size_t row = 0; row < level.size(); ++row) {
      Level::Detour main = farthest_of(arriving[row], level.begin_of(row));
      const Place& begin = main.target.place;
      if (!main.path.empty() && main.path.back().to != begin) {
        main.path.push_back({main.path.back().to, begin});
      }
      std::vector<Level::Detour> detours;
      for (Level::Detour& path : arriving[row]) {
        if (way_back(path) <= kLongestReturn * interval_) {
          detours.push_back(std::move(path));
        } else {
          paths_.push_back(std::move(path.path));
        }
      }
      level.drive(main.target, detours, main.path);
      go_outwards(std::move(main.path), number);
    }
  }

  /// Returns the distance from the target point of a path to the beginning of the path, mm.
  static double way_back(const Level::Detour& path) {
    return drawing::distance(path.path.front().from, path.target.place);
  }

  /// Removes and returns the path, among those that arrive at a row, whose beginning is farthest
  /// from its target. If no path arrives, returns an empty path with the target `begin`.
  static Level::Detour farthest_of(std::vector<Level::Detour>& arriving, const Level::On& begin) {
    if (arriving.empty()) return {.target = begin};
    const auto farthest = std::ranges::max_element(arriving, {}, way_back);
    Level::Detour main = std::move(*farthest);
    arriving.erase(farthest);
    return main;
  }

  /// Drives along a line. A spur is driven towards its corner.
  void drive_line(const FillRest& line, std::size_t level) {
    std::vector<Place> places = line.places;
    if (line.is_spur) std::ranges::reverse(places);
    std::vector<Stroke> path;
    for (std::size_t i = 1; i < places.size(); ++i) {
      if (places[i - 1] != places[i]) path.push_back({places[i - 1], places[i]});
    }
    if (!path.empty()) go_outwards(std::move(path), level);
  }

  /// Keeps a path open if its end is near a row of the next level outside. Otherwise the path is
  /// complete.
  void go_outwards(std::vector<Stroke> path, std::size_t level) {
    const auto next = level > 0 ? levels_[level - 1]->nearest(path.back().to) : std::nullopt;
    if (next) {
      open_.push_back({*next, std::move(path)});
    } else {
      paths_.push_back(std::move(path));
    }
  }

  double interval_;
  std::vector<std::unique_ptr<Level>> levels_;
  std::vector<Level::Detour> open_;  ///< Paths that end near rows of the next level.
  std::vector<std::vector<Stroke>> paths_;
};

}  // namespace

std::vector<std::vector<Stroke>> fill_chains(std::vector<FillRows> rows,
                                             const std::vector<FillRest>& rests,
                                             double interval_mm) {
  return ChainMaker{std::move(rows), interval_mm}.make(rests);
}

}  // namespace sim::cut
