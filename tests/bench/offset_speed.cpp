/// Measures the input elements per second that the offset processes, for each family of contours,
/// and how the time grows with the number of elements.
/// Run: build/release/tests/bench_offset_speed

#include <benchmark/benchmark.h>

#include <cmath>
#include <vector>

#include "tests/support/contour_corpus.hpp"

namespace {

constexpr std::size_t kCases = 400;

void run_cases(benchmark::State& state, const std::vector<proof::OffsetCase>& cases) {
  sim::ContourOffset offsetter;
  std::size_t elements = 0;
  std::size_t offsets = 0;
  for (auto _ : state) {
    for (const proof::OffsetCase& one : cases) {
      benchmark::DoNotOptimize(offsetter.offset(one.contour.view(), one.distance_mm));
      elements += one.contour.vertices.size();
    }
    offsets += cases.size();
  }
  state.counters["elements/s"] =
      benchmark::Counter(static_cast<double>(elements), benchmark::Counter::kIsRate);
  state.counters["offsets/s"] =
      benchmark::Counter(static_cast<double>(offsets), benchmark::Counter::kIsRate);
}

void corpus(benchmark::State& state, proof::Corpus family, std::size_t count) {
  std::vector<proof::OffsetCase> cases;
  for (std::uint64_t seed = 1; seed <= count; ++seed) {
    cases.push_back(proof::random_case(family, seed));
  }
  run_cases(state, cases);
}

/// Measures small teeth around a circle. An element has equally few neighbours at any size.
void growth(benchmark::State& state) {
  const auto count = static_cast<std::size_t>(state.range(0));
  proof::OffsetCase gear;
  const double radius = static_cast<double>(count) / 8.0;
  for (std::size_t i = 0; i < count; ++i) {
    const double angle = 6.283185307179586 * static_cast<double>(i) / static_cast<double>(count);
    const double size = radius + (i % 2 == 0 ? 0.0 : 1.0);
    gear.contour.vertices.push_back({size * std::cos(angle), size * std::sin(angle), 0.1});
  }
  gear.contour.end_loop();
  gear.distance_mm = -0.4;
  run_cases(state, {gear});
  state.SetComplexityN(state.range(0));
}

BENCHMARK_CAPTURE(corpus, nest, proof::Corpus::kNest, kCases);
BENCHMARK_CAPTURE(corpus, mech, proof::Corpus::kMech, kCases);
BENCHMARK_CAPTURE(corpus, glyphs, proof::Corpus::kGlyphs, kCases);
BENCHMARK_CAPTURE(corpus, spline, proof::Corpus::kSpline, kCases);
BENCHMARK_CAPTURE(corpus, star20, proof::Corpus::kStar20, kCases);
BENCHMARK_CAPTURE(corpus, star100, proof::Corpus::kStar100, kCases);
BENCHMARK_CAPTURE(corpus, star1000, proof::Corpus::kStar1000, 20);
BENCHMARK(growth)->RangeMultiplier(10)->Range(100, 100000)->Complexity(benchmark::oNLogN);

}  // namespace
