#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "host-sim/import/curve.hpp"
#include "host-sim/import/drawing.hpp"
#include "host-sim/import/outline_box.hpp"

namespace sim::drawing {

/// A region outside of which nothing is seen, as chords in mm.
struct SvgClip {
  /// One shape of it; the region is all of them together.
  struct Area {
    std::vector<std::vector<Place>> loops;  ///< Each ends where it begins.
    FillRule rule = FillRule::kNonZero;
    OutlineBox box;
  };
  std::string name;    ///< `clip path "a"`.
  std::string remedy;  ///< For shapes that cross its edge.
  std::vector<Area> areas;

  /// Adds a shape, its subpaths closed.
  void add(const std::vector<std::vector<Shape>>& subpaths, FillRule rule);
  /// Returns the number of its chords.
  [[nodiscard]] std::size_t size() const;
};

enum class ClipSide : std::uint8_t { kInside, kOutside, kAcross };

/// Returns on which side of a clip's edge a subpath lies. What runs along the edge, nearer than
/// kClipEdgeMm, is on either side; the whole of it there is inside.
/// @param chords the subpath as chords, mm
[[nodiscard]] ClipSide side_of(const std::vector<Place>& chords, const SvgClip& clip);

/// Returns whether a filled subpath covers some of a clip's edge, so that the edge is seen.
[[nodiscard]] bool covers_edge(const std::vector<Place>& chords,
                               FillRule rule,
                               const SvgClip& clip);

inline constexpr double kClipEdgeMm = 0.02;
/// Chords are within this of their curves, mm.
inline constexpr double kClipChordMm = 0.005;

}  // namespace sim::drawing
