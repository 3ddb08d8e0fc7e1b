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
  sim::Contour plain{};  ///< The contour before points were doubled and spikes added.
};

/// Families of contours as other offset programs were measured on.
enum class Corpus {
  kStar20,  ///< Stars of lines and arcs with so many elements.
  kStar100,
  kStar1000,
  kNest,     ///< Parts of nesting problems, turned and scaled.
  kGlyphs,   ///< Letters with their counters, as chords.
  kSpline,   ///< Smooth closed B-splines as 400-gons.
  kMech,     ///< Right angles with fillets; whole, half and quarter millimetres.
  kIslands,  ///< Plates with holes with islands, all at once.
  kHostile,  ///< What breaks offset programs.
};

[[nodiscard]] const char* name_of(Corpus corpus);

/// The same case for the same seed. Material is on the left.
[[nodiscard]] OffsetCase random_case(Corpus corpus, std::uint64_t seed);

/// A star around the origin that does not cross itself.
[[nodiscard]] sim::Contour random_star(Random& random,
                                       std::size_t elements,
                                       double min_radius_mm,
                                       double max_radius_mm);

/// To four decimals, as programs have them.
[[nodiscard]] double programmed(double mm);

/// A star of 3 elements up to this many, whose outline begins within a line; places are programmed,
/// and no arc is of more than half a turn. Of 8 to 30 mm.
[[nodiscard]] sim::Contour programmed_star(Random& random, std::size_t max_elements);

}  // namespace proof
