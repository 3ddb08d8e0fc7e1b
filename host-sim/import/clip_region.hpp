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

/// A region outside of which nothing is seen, as chords in mm.
struct ClipRegion {
  /// One shape of it; the region is all of them together.
  struct Area {
    std::vector<std::vector<Place>> loops;  ///< Each ends where it begins.
    FillRule rule = FillRule::kNonZero;
    OutlineBox box;
  };
  std::string name;    ///< `clip path "a"`, `boundary of INSERT 2F`.
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
[[nodiscard]] ClipSide side_of(const std::vector<Place>& chords, const ClipRegion& clip);

/// Returns whether a filled subpath covers some of a clip's edge, so that the edge is seen.
[[nodiscard]] bool covers_edge(const std::vector<Place>& chords,
                               FillRule rule,
                               const ClipRegion& clip);

/// Leaves of a picture what lies within a clip: pixels whose middle is outside belong to it no
/// longer. @param to_mm of places in the picture, in pixels @pre the map has an area
void clip_picture(picture::GreyImage& image, const Transform& to_mm, const ClipRegion& clip);

using ClipRegions = std::vector<std::shared_ptr<const ClipRegion>>;

/// What is seen of a row of shapes within clips.
enum class Sight : std::uint8_t {
  kWhole,
  kNothing,
  kPart,     ///< It crosses the edge of a clip, or shows it.
  kTooMuch,  ///< There are too many chords to compare.
};

struct SightOfShapes {
  Sight sight = Sight::kWhole;
  const ClipRegion* clip = nullptr;  ///< The one that hides shapes or a part of them.
};

/// Compares rows of shapes with clips, as long as its work lasts.
class ClipComparison {
 public:
  /// @param steps pairs of chords
  explicit ClipComparison(std::size_t steps) : steps_{steps} {}

  /// Returns what is seen of a row of shapes, in mm, that lies within all clips or not.
  /// @param fill rule of the shapes where their area is painted
  [[nodiscard]] SightOfShapes compare(const std::vector<Shape>& shapes,
                                      const ClipRegions& clips,
                                      std::optional<FillRule> fill);

 private:
  std::size_t steps_;
};

/// Pairs of chords: about a second.
inline constexpr std::size_t kMostClipSteps = 200'000'000;

inline constexpr double kClipEdgeMm = 0.02;
/// Chords are within this of their curves, mm.
inline constexpr double kClipChordMm = 0.005;

}  // namespace sim::drawing
