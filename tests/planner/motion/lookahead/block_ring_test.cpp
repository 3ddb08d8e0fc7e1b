#include "planner/motion/lookahead/block_ring.hpp"

#include <gtest/gtest.h>

#include <deque>
#include <vector>

#include "tests/support/random_source.hpp"
#include "tests/support/trials.hpp"

namespace cnc::motion {
namespace {

/// Reference without a capacity limit: all blocks that were ever added, and the number of driven
/// ones.
struct Model {
  std::vector<std::int32_t> ends;  ///< Steps on X at the end of each block, which identify the
                                   ///< block.
  std::size_t driven = 0;
  std::size_t forgotten = 0;  ///< Driven blocks that are no longer kept.
  std::int32_t begin = 0;     ///< Start of the first block that is kept, steps.
};

std::int32_t steps_of(const AxisArray<StepPosition>& place) { return place[0].nearest_step(); }

TEST(BlockRing, IsARowOfBlocksOfWhichTheLastDrivenCanReturn) {
  const proof::Trials trials{200};
  for (const std::uint64_t seed : trials) {
    proof::Random random{seed};
    const std::size_t kept = random.below(4);
    std::vector<Block> storage(kept + 1 + random.below(6));
    BlockRing ring{storage, kept};
    Model model;
    bool keeps_all = false;
    for (int step = 0; step < 200; ++step) {
      const std::size_t waiting = model.ends.size() - model.driven;
      const std::size_t still = model.driven - model.forgotten;
      const std::size_t choice = random.below(10);
      if (choice < 4 && !ring.full()) {
        if (waiting + still == storage.size()) model.begin = model.ends[model.forgotten++];
        Block block;
        block.end[0] = StepPosition::whole(step + 1);
        model.ends.push_back(step + 1);
        EXPECT_EQ(steps_of(ring.add(block).end), step + 1);
      } else if (choice < 7 && waiting > 0) {
        ring.pass_front();
        ++model.driven;
      } else if (choice < 8 && still > 0) {
        EXPECT_EQ(steps_of(ring.newest_kept().end), model.ends[model.driven - 1]);
        ring.return_newest_kept();
        --model.driven;
      } else if (choice == 8) {
        keeps_all = !keeps_all;
        ring.keep_all(keeps_all);
      } else if (random.below(10) == 0) {
        AxisArray<StepPosition> place{};
        place[0] = StepPosition::whole(1000 + step);
        ring.forget_kept(place);
        model.forgotten = model.driven;
        model.begin = 1000 + step;
      }
      ASSERT_EQ(ring.size(), model.ends.size() - model.driven);
      ASSERT_EQ(ring.kept(), model.driven - model.forgotten);
      EXPECT_EQ(steps_of(ring.start()), model.begin);
      EXPECT_EQ(steps_of(ring.start_of_front()),
                ring.kept() > 0 ? model.ends[model.driven - 1] : model.begin);
      EXPECT_EQ(ring.full(),
                ring.size() >= ring.capacity() ||
                    (keeps_all && ring.size() + ring.kept() == storage.size()));
      for (std::size_t i = 0; i < ring.size(); ++i) {
        EXPECT_EQ(steps_of(ring.at(i).end), model.ends[model.driven + i]);
      }
    }
  }
}

}  // namespace
}  // namespace cnc::motion
