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
  /// The area of one shape. The region is the union of all its areas.
  struct Area {
    /// Closed loops of points, mm. Each loop repeats its first point at its end.
    std::vector<std::vector<Place>> loops;
    FillRule rule = FillRule::kNonZero;
    OutlineBox box;
  };
  /// Name of the clip in messages, for example `clip path "a"` or `boundary of INSERT 2F`.
  std::string name;
  std::string remedy;  ///< Remedy in messages about shapes that cross the edge of the region.
  std::vector<Area> areas;

  /// Adds a shape as one more area. Closes its open subpaths.
  void add(const std::vector<std::vector<Shape>>& subpaths, FillRule rule);
  /// Returns the number of chords of all areas.
  [[nodiscard]] std::size_t size() const;
};

enum class ClipSide : std::uint8_t { kInside, kOutside, kAcross };

/// Returns whether a subpath is inside or outside of a clip, or crosses its edge. Parts of the
/// subpath within kClipEdgeMm of the edge count as both inside and outside. A subpath that is
/// within kClipEdgeMm of the edge along its whole length is inside.
[[nodiscard]] ClipSide side_of(const std::vector<Place>& chords, const ClipRegion& clip);

/// Returns whether a filled subpath covers a part of the edge of a clip. This part is then visible
/// as an edge of the filled area.
[[nodiscard]] bool covers_edge(const std::vector<Place>& chords,
                               FillRule rule,
                               const ClipRegion& clip);

/// Sets the cover of pixels whose middle is outside of a clip to 0, so that they do not belong to
/// the picture.
/// @param to_mm maps points of the picture, in pixels, to mm
/// @pre the determinant of `to_mm` is not 0
void clip_picture(picture::GreyImage& image, const Transform& to_mm, const ClipRegion& clip);

using ClipRegions = std::vector<std::shared_ptr<const ClipRegion>>;

/// The part of a row of shapes that its clips leave visible.
enum class Sight : std::uint8_t {
  kWhole,
  kNothing,
  /// A part of the row is visible: the row crosses the edge of a clip, or its filled area covers a
  /// part of this edge.
  kPart,
  kTooMuch,  ///< There are more pairs of chords than may be compared.
};

struct SightOfShapes {
  Sight sight = Sight::kWhole;
  const ClipRegion* clip = nullptr;  ///< The clip that hides all or part of the row.
};

/// Compares rows of shapes with clips. All comparisons together have a bounded number of steps.
class ClipComparison {
 public:
  /// @param steps greatest number of pairs of chords to compare
  explicit ClipComparison(std::size_t steps) : steps_{steps} {}

  /// Returns which part of a row of shapes, in mm, is visible, that is, within all clips.
  /// @param fill rule of the shapes if their area is painted
  [[nodiscard]] SightOfShapes compare(const std::vector<Shape>& shapes,
                                      const ClipRegions& clips,
                                      std::optional<FillRule> fill);

 private:
  std::size_t steps_;
};

/// Greatest number of pairs of chords to compare in one drawing. This many take about a second.
inline constexpr std::size_t kMaxClipSteps = 200'000'000;

inline constexpr double kClipEdgeMm = 0.02;
/// Greatest distance between a curve and its chords when shapes are compared with clips, mm.
inline constexpr double kClipChordMm = 0.005;

}  // namespace sim::drawing
