#include "host-sim/contour/vanished.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "host-sim/cut/clearance.hpp"

namespace sim {
namespace {

struct LoopSize {
  double area_mm2 = 0.0;  ///< Area that the loop encloses, positive if the loop turns left.
  double length_mm = 0.0;
};

std::vector<cut::Stroke> strokes_of(const Contour& contour, std::size_t loop) {
  std::vector<cut::Stroke> strokes;
  const std::uint32_t first = contour.view().loop_begin(loop);
  const std::uint32_t end = contour.loop_ends[loop];
  for (std::uint32_t i = first; i < end; ++i) {
    const ContourVertex& from = contour.vertices[i];
    const ContourVertex& to = contour.vertices[i + 1 < end ? i + 1 : first];
    if (from.x == to.x && from.y == to.y) continue;
    strokes.push_back({.from = {from.x, from.y}, .to = {to.x, to.y}, .bulge = from.bulge});
  }
  return strokes;
}

LoopSize size_of(const std::vector<cut::Stroke>& loop) {
  LoopSize size;
  for (const cut::Stroke& stroke : loop) {
    const double length = length_of(stroke);
    const double sweep = 4.0 * std::atan(stroke.bulge);
    // Radius of an arc, with the sign of its sweep; 0 for a line.
    const double radius = sweep == 0.0 ? 0.0 : length / sweep;
    size.area_mm2 += 0.5 * drawing::cross(stroke.from, stroke.to);
    size.area_mm2 += 0.5 * radius * radius * (sweep - std::sin(sweep));
    size.length_mm += length;
  }
  return size;
}

/// Returns a contour that consists of one loop, whose inside is on its left.
Contour alone(const std::vector<cut::Stroke>& loop, bool turns_left) {
  Contour contour;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const cut::Stroke& stroke = turns_left ? loop[i] : loop[loop.size() - 1 - i];
    const drawing::Place& from = turns_left ? stroke.from : stroke.to;
    contour.vertices.push_back({from.x(), from.y(), turns_left ? stroke.bulge : -stroke.bulge});
  }
  contour.end_loop();
  return contour;
}

/// Returns whether an offset shrinks a loop to nothing. The radius of the largest circle inside the
/// loop is at least the area divided by the length of the loop. If the distance is less than this
/// bound, the offset need not be computed.
bool shrinks_to_nothing(const std::vector<cut::Stroke>& loop,
                        const LoopSize& size,
                        double distance_mm,
                        ContourOffset& offsetter) {
  const bool shrinks = size.area_mm2 < 0.0 ? distance_mm > 0.0 : distance_mm < 0.0;
  const double wide = std::abs(size.area_mm2) / std::max(size.length_mm, 1.0e-9);
  if (!shrinks || std::abs(distance_mm) < wide) return false;
  const Contour contour = alone(loop, size.area_mm2 > 0.0);
  return offsetter.offset(contour.view(), -std::abs(distance_mm)).loop_ends.size() == 0;
}

class VanishedSearch {
 public:
  VanishedSearch(const Contour& result, double distance_mm)
      : distance_mm_{distance_mm}, left_{kReach * std::abs(distance_mm)} {
    for (std::size_t loop = 0; loop < result.loop_ends.size(); ++loop) {
      for (const cut::Stroke& stroke : strokes_of(result, loop)) left_.add(stroke, 0);
    }
    left_.prepare();
  }

  /// Appends the pieces of a loop that have vanished, or the whole loop if all of it has vanished.
  void search(const std::vector<cut::Stroke>& loop,
              const Vanished& whole,
              std::vector<Vanished>& found) const {
    const std::size_t before = found.size();
    bool goes_on = false;
    bool all = true;
    for (const cut::Stroke& stroke : loop) {
      const bool gone = has_vanished(stroke);
      all = all && gone;
      if (gone && !goes_on) {
        found.push_back(whole);
        found.back().is_whole = false;
        found.back().piece_at = place_at(stroke, 0.5);
      }
      if (gone) found.back().piece_mm += length_of(stroke);
      goes_on = gone;
    }
    if (!all) return;
    found.resize(before);
    found.push_back(whole);
  }

 private:
  /// Radius of the search for the result, as a multiple of the offset distance. It is greater than
  /// the comparison requires.
  static constexpr double kReach = 1.5;

  [[nodiscard]] bool has_vanished(const cut::Stroke& stroke) const {
    constexpr std::array kShares{1.0 / 6.0, 0.5, 5.0 / 6.0};
    const auto gone = std::ranges::count_if(kShares, [&](double share) {
      const drawing::Place moved =
          place_at(stroke, share) + distance_mm_ * cut::right_of(tangent_at(stroke, share));
      return left_.nearest(moved).distance_mm > std::abs(distance_mm_);
    });
    return gone >= 2;
  }

  double distance_mm_;
  cut::Clearance left_;
};

}  // namespace

std::string Vanished::text() const {
  const char* const kind = is_hole ? "hole" : "loop";
  if (is_whole)
    return fmt::format("the {} that begins at {:.3f} {:.3f} vanishes", kind, begin.x(), begin.y());
  return fmt::format(
      "{:.1f} mm of the {} that begins at {:.3f} {:.3f}, from about {:.3f} {:.3f} on, "
      "vanish, because the space there is too narrow",
      piece_mm,
      kind,
      begin.x(),
      begin.y(),
      piece_at.x(),
      piece_at.y());
}

std::vector<Vanished> vanished(const Contour& part,
                               const Contour& result,
                               double distance_mm,
                               ContourOffset& offsetter) {
  std::vector<Vanished> found;
  if (distance_mm == 0.0) return found;
  const VanishedSearch search{result, distance_mm};
  for (std::size_t loop = 0; loop < part.loop_ends.size(); ++loop) {
    const std::vector<cut::Stroke> strokes = strokes_of(part, loop);
    if (strokes.empty()) continue;
    const LoopSize size = size_of(strokes);
    const Vanished whole{.is_hole = size.area_mm2 < 0.0, .begin = strokes.front().from};
    if (result.loop_ends.empty() || shrinks_to_nothing(strokes, size, distance_mm, offsetter)) {
      // If no material is left, a growing hole disappears together with the material around it. In
      // this case the outer loop counts as vanished, and the hole does not.
      const bool goes_with_loop = result.loop_ends.empty() && whole.is_hole && distance_mm < 0.0;
      if (!goes_with_loop) found.push_back(whole);
      continue;
    }
    search.search(strokes, whole, found);
  }
  return found;
}

}  // namespace sim
