// Tests lines of any size on machines with any settings. The controller must drive or refuse a
// line; a violated contract would stop it.

#include <gtest/gtest.h>

#include <array>
#include <csignal>
#include <cstdint>
#include <cstdio>

#include "tests/support/hostile_program.hpp"
#include "tests/support/machine_bench.hpp"
#include "tests/support/trials.hpp"

namespace proof {
namespace {

std::uint64_t seed_now = 0;

/// Prints the seed: a violated contract ends the process, so that no test result would name it.
void tell_seed(int /*signal*/) {
  std::fprintf(
      stderr, "to repeat: KERFLINE_SEED=%llu\n", static_cast<unsigned long long>(seed_now));
}

/// A bench with an operator who holds, resumes and overrides in half of the jobs.
class HostileBench : public MachineBench {
 public:
  explicit HostileBench(Random& random) : random_{random}, has_operator_{random.chance(0.5)} {}

  /// Drives a job for a limited number of cycles, then drops the rest as by a reset.
  void drive(const HostileJob& job) {
    for (const auto& [number, value] : job.settings) {
      if (!machine().idle()) break;
      static_cast<void>(
          machine().change_setting(static_cast<std::uint16_t>(number), static_cast<float>(value)));
    }
    for (const std::string& line : job.lines) {
      while (machine().busy() && !machine().locked() && turns_ > 0) turn();
      if (machine().busy() || machine().locked()) break;
      ++(machine().accept(line) ? refused : taken);
    }
    while (!machine().idle() && !machine().locked() && turns_ > 0) turn();
    machine().reset();
    for (int i = 0; i < 100; ++i) turn();
  }

  std::uint64_t taken = 0;
  std::uint64_t refused = 0;

 private:
  void turn() {
    if (has_operator_) operate();
    controller.turn();
    --turns_;
  }

  void operate() {
    constexpr std::array kFeeds = {10, 50, 100, 200};
    constexpr std::array kRapids = {25, 50, 100};
    switch (random_.below(400)) {
      case 0:
        return machine().feed_hold();
      case 1:
        return machine().set_overrides({.feed = kFeeds[random_.below(kFeeds.size())],
                                        .rapid = kRapids[random_.below(kRapids.size())]});
      case 2:
        controller.panel().door = !controller.panel().door;
        return;
      default:
        if (random_.chance(0.02)) machine().resume();
    }
  }

  Random& random_;
  bool has_operator_;
  int turns_ = 3000;
};

TEST(HostilePrograms, AreDrivenOrRefusedAndReachNoContract) {
  const auto before = std::signal(SIGABRT, tell_seed);
  const Trials trials{6000};
  std::uint64_t taken = 0;
  std::uint64_t refused = 0;
  for (const std::uint64_t seed : trials) {
    seed_now = seed;
    Random random{seed};
    const HostileJob job{random};
    HostileBench bench{random};
    bench.drive(job);
    taken += bench.taken;
    refused += bench.refused;
  }
  static_cast<void>(std::signal(SIGABRT, before));
  // Otherwise the lines would only test the interpreter.
  EXPECT_GT(taken, refused);
}

}  // namespace
}  // namespace proof
