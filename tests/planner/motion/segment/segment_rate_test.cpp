#include "planner/motion/segment/segment_rate.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "planner/motion/motors/output_delay.hpp"

namespace cnc::motion {
namespace {

/// Lengths of pieces in ticks, and twice the energy of all pieces.
struct Pieces {
  std::vector<std::uint32_t> ticks{};
  double doubled_energy = 0.0;
};

constexpr std::uint32_t kCell = 1068;

/// Fills cells with slices of changing duty, of `slice` ticks each.
Pieces pieces_of_slices(std::uint32_t slice, int cells, double& doubled_energy) {
  OutputDelay delay;
  delay.clear(2);
  Pieces pieces;
  float duty = 0.1F;
  for (int cell = 0; cell < cells; ++cell) {
    for (std::uint32_t tick = 0; tick < kCell;) {
      const std::uint32_t end = std::min(tick + slice, kCell);
      const float next = duty < 0.9F ? duty + 0.01F : 0.1F;
      delay.add({.start_duty = duty, .end_duty = next}, end);
      doubled_energy += static_cast<double>(duty + next) * 65'535.0 * (end - tick);
      duty = next;
      tick = end;
    }
    delay.close_cell();
    for (std::uint32_t tick = 0; tick < kCell;) {
      const OutputPiece piece = delay.take();
      pieces.ticks.push_back(piece.ticks);
      pieces.doubled_energy += (piece.start + piece.end) * static_cast<double>(piece.ticks);
      tick += piece.ticks;
    }
  }
  return pieces;
}

/// Returns the greatest number of pieces that begin within `window` ticks.
std::size_t max_within(const std::vector<std::uint32_t>& ticks, std::uint32_t window) {
  std::size_t most = 0;
  for (std::size_t first = 0; first < ticks.size(); ++first) {
    std::uint32_t sum = 0;
    std::size_t count = 0;
    while (first + count < ticks.size() && sum < window) sum += ticks[first + count++];
    most = std::max(most, count);
  }
  return most;
}

TEST(SegmentRate, LetsAFewShortOnesThroughAfterLongOnes) {
  SegmentRate rate;
  int count = 0;
  while (rate.allows_short()) {
    rate.begin();
    rate.pass(1);
    ++count;
  }
  EXPECT_EQ(count, SegmentRate::kMaxSpare / SegmentRate::kShortest);
  rate.pass(SegmentRate::kShortest);
  EXPECT_TRUE(rate.allows_short());
}

// At most 63 segments wait, and must last five cycles of 4,000 ticks.
TEST(OutputDelay, HasNoMorePiecesThanAQueueOfSegmentsBears) {
  for (const std::uint32_t slice : {7U, 60U, 240U, 350U, 534U, 1068U}) {
    double doubled_energy = 0.0;
    const Pieces pieces = pieces_of_slices(slice, 400, doubled_energy);
    EXPECT_LE(max_within(pieces.ticks, 20'000), 63U) << slice;
    EXPECT_NEAR(pieces.doubled_energy / doubled_energy, 1.0, 3.0e-4) << slice;
  }
}

TEST(OutputDelay, KeepsPiecesThatAreLongEnoughApart) {
  double doubled_energy = 0.0;
  EXPECT_EQ(pieces_of_slices(534, 400, doubled_energy).ticks.size(), 800U);
}

}  // namespace
}  // namespace cnc::motion
