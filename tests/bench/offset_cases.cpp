/// Prints contours of a corpus of offset_speed.cpp with their offset distances, as input for other
/// offset programs (peers/README.md).
/// Run: build/release/tests/bench_offset_cases star100 400
///
/// Each case is a line: distance in mm, number of loops, number of vertices of each loop, then x, y
/// and bulge of each vertex, with all their digits.

#include <cinttypes>
#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "tests/support/contour_corpus.hpp"

namespace {

void print(const proof::OffsetCase& one) {
  const auto view = one.contour.view();
  std::printf("%.17g %zu", one.distance_mm, view.loop_ends.size());
  for (std::size_t loop = 0; loop < view.loop_ends.size(); ++loop) {
    std::printf(" %" PRIu32, view.loop_ends[loop] - view.loop_begin(loop));
  }
  for (const auto& vertex : view.vertices) {
    std::printf(" %.17g %.17g %.17g", vertex.x, vertex.y, vertex.bulge);
  }
  std::printf("\n");
}

}  // namespace

int main(int count, char** arguments) {
  constexpr auto kLast = static_cast<int>(proof::Corpus::kHostile);
  if (count != 3) return 2;
  const std::uint64_t cases = std::strtoull(arguments[2], nullptr, 10);
  for (int i = 0; i <= kLast; ++i) {
    const auto family = static_cast<proof::Corpus>(i);
    if (std::string_view{arguments[1]} != proof::name_of(family)) continue;
    for (std::uint64_t seed = 1; seed <= cases; ++seed) print(proof::random_case(family, seed));
    return 0;
  }
  std::fprintf(stderr, "no corpus %s\n", arguments[1]);
  return 2;
}
