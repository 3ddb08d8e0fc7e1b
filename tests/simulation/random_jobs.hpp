#pragma once

#include "tests/support/drive.hpp"
#include "tests/support/random_source.hpp"

namespace proof {

/// A random program on a random machine without a limit of jerk; some programs weld their lines.
struct WeldedJob {
  TestMachine machine;
  Program program;

  explicit WeldedJob(Random& random) : machine{random_machine(random)} {
    program = random_program(random, machine);
    if (random.chance(0.4)) program.weld_mm = static_cast<float>(random.magnitude(1.0e-4, 0.1));
  }
};

/// Limits jerk so that acceleration reaches its limit after `ramp_s` seconds.
inline void limit_jerk(TestMachine& machine, double ramp_s) {
  for (std::size_t axis = 0; axis < cnc::kAxisCount; ++axis) {
    machine.limits.jerk_mm_s3[axis] =
        machine.limits.acceleration_mm_s2[axis] / static_cast<float>(ramp_s);
  }
}

/// A random program on a random machine with limited jerk.
struct Job {
  TestMachine machine;
  Program program;

  explicit Job(Random& random, const ProgramSize& size = {}) : machine{random_machine(random)} {
    program = random_program(random, machine, size);
    limit_jerk(machine, random.magnitude(1.0e-3, 0.2));
  }
};

/// An operator that holds, resumes and overrides at random.
class Meddler {
 public:
  explicit Meddler(std::uint64_t seed) : random_{seed} {}

  void operator()(cnc::motion::Segmenter& segmenter, std::size_t /*cut*/) {
    if (segmenter.halted() && random_.chance(0.2)) segmenter.go_on();
    if (!random_.chance(0.02)) return;
    const double feed = random_.between(0.1, 2.0);
    const double rapid = random_.between(0.05, 1.0);
    switch (random_.below(3)) {
      case 0:
        return segmenter.halt();
      case 1:
        return segmenter.go_on();
      default:
        segmenter.set_overrides(
            {.feed = static_cast<float>(feed), .rapid = static_cast<float>(rapid)});
    }
  }

 private:
  Random random_;
};

}  // namespace proof
