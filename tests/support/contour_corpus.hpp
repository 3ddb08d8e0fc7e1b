#pragma once

#include <string>
#include <vector>

#include "host-sim/contour/contour_offset.hpp"
#include "tests/support/random_source.hpp"

namespace proof {

/// A contour and a distance to offset it by.
struct OffsetCase {
  sim::Contour contour;
  double distance_mm = 0.0;
  sim::Contour plain{};  ///< The contour before points were doubled and spikes were added.
};

/// Families of contours; papers on other offset programs measure with the same families.
enum class Corpus {
  kStar20,  ///< Stars of lines and arcs; the number in the name is the number of elements.
  kStar100,
  kStar1000,
  kNest,     ///< Parts from nesting problems, rotated and scaled.
  kGlyphs,   ///< Letters with their counters, drawn as chords.
  kSpline,   ///< Smooth closed B-splines as 400-gons.
  kMech,     ///< Right angles with fillets; whole, half and quarter millimetres.
  kIslands,  ///< Plates with holes that contain islands.
  kHostile,  ///< Shapes that break offset programs.
};

[[nodiscard]] const char* name_of(Corpus corpus);

/// Returns the case of a seed, which is the same in every run. Material is on the left.
[[nodiscard]] OffsetCase random_case(Corpus corpus, std::uint64_t seed);

/// Returns a star around the origin that does not cross itself.
[[nodiscard]] sim::Contour random_star(Random& random,
                                       std::size_t elements,
                                       double min_radius_mm,
                                       double max_radius_mm);

/// Returns a length rounded to four decimals, as in programs.
[[nodiscard]] double programmed(double mm);

/// Returns a star of 8 to 30 mm with 3 to `max_elements` elements, whose outline begins within a
/// line. Coordinates have four decimals, and no arc is of more than half a turn.
[[nodiscard]] sim::Contour programmed_star(Random& random, std::size_t max_elements);

}  // namespace proof
