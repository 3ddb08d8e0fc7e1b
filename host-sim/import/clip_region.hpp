#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "host-sim/import/curve.hpp"
#include "host-sim/import/drawing.hpp"
#include "host-sim/import/outline_box.hpp"

namespace sim::drawing {

/// A clip: a region outside of which nothing is visible. Its edge is stored as chords, in mm.
struct ClipRegion {
  /// One shape of the region. The region is the union of all its areas.
  struct Area {
    std::vector<std::vector<Place>> loops;  ///< Each loop ends at its first point.
    FillRule rule = FillRule::kNonZero;
    OutlineBox box;
  };
  std::string name;    ///< Name for messages: `clip path "a"`, `boundary of INSERT 2F`.
  std::string remedy;  ///< Remedy in messages about shapes that cross the region's edge.
  std::vector<Area> areas;

  /// Adds a shape as one more area. Open subpaths are closed.
  void add(const std::vector<std::vector<Shape>>& subpaths, FillRule rule);
  /// Returns the number of chords of all areas.
  [[nodiscard]] std::size_t size() const;
};

enum class ClipSide : std::uint8_t { kInside, kOutside, kAcross };

/// Returns on which side of a clip's edge a subpath lies. Parts of the subpath that are nearer to
/// the edge than kClipEdgeMm count for either side. A subpath that is that near everywhere is
/// inside.
[[nodiscard]] ClipSide side_of(const std::vector<Place>& chords, const ClipRegion& clip);

/// Returns whether a filled subpath covers a part of a clip's edge, so that this part of the edge
/// is visible.
[[nodiscard]] bool covers_edge(const std::vector<Place>& chords,
                               FillRule rule,
                               const ClipRegion& clip);

/// Removes from a picture the pixels whose middle lies outside a clip: they no longer belong to the
/// picture.
/// @param to_mm maps points of the picture, in pixels, to mm
/// @pre the map has an area
void clip_picture(picture::GreyImage& image, const Transform& to_mm, const ClipRegion& clip);

using ClipRegions = std::vector<std::shared_ptr<const ClipRegion>>;

/// Visible part of a row of shapes within clips.
enum class Sight : std::uint8_t {
  kWhole,
  kNothing,
  kPart,     ///< The row crosses the edge of a clip, or its filled area makes the edge visible.
  kTooMuch,  ///< There are too many chords to compare.
};

struct SightOfShapes {
  Sight sight = Sight::kWhole;
  const ClipRegion* clip = nullptr;  ///< The clip that hides all or part of the row.
};

/// Compares rows of shapes with clips until a bound on the work is reached.
class ClipComparison {
 public:
  /// @param steps greatest number of pairs of chords to compare
  explicit ClipComparison(std::size_t steps) : steps_{steps} {}

  /// Returns which part of a row of shapes, in mm, is visible: the part that lies within all clips.
  /// @param fill rule of the shapes if their area is painted
  [[nodiscard]] SightOfShapes compare(const std::vector<Shape>& shapes,
                                      const ClipRegions& clips,
                                      std::optional<FillRule> fill);

 private:
  std::size_t steps_;
};

/// Greatest number of pairs of chords to compare: they take about a second.
inline constexpr std::size_t kMaxClipSteps = 200'000'000;

inline constexpr double kClipEdgeMm = 0.02;
/// Greatest distance of chords from their curves, mm.
inline constexpr double kClipChordMm = 0.005;

}  // namespace sim::drawing
