#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <string>

namespace proof {

/// KERFLINE_TRIALS, else what is usual; of that no more than KERFLINE_MOST_TRIALS, where tests
/// are to be shorter than usual and none is to be longer.
[[nodiscard]] inline std::uint64_t trials_wanted(std::uint64_t usual) {
  const char* const count = std::getenv("KERFLINE_TRIALS");
  if (count != nullptr) return std::stoull(count);
  const char* const most = std::getenv("KERFLINE_MOST_TRIALS");
  return most != nullptr ? std::min<std::uint64_t>(usual, std::stoull(most)) : usual;
}

/// How many random trials a property test makes. Each test names the number
/// that takes it about half a minute in a release build; the full proof is
///   KERFLINE_TRIALS=100000 build/release/tests/simulation_tests
/// one trial alone, as named by a failure, is KERFLINE_SEED=<seed>, and both go
/// on from a seed with so many.
class Trials {
 public:
  explicit Trials(std::uint64_t usual) {
    const char* const seed = std::getenv("KERFLINE_SEED");
    if (seed != nullptr) {
      first_ = std::stoull(seed);
      usual = 1;
    }
    end_ = first_ + trials_wanted(usual);
  }

  [[nodiscard]] std::uint64_t first_seed() const { return first_; }
  [[nodiscard]] std::uint64_t end_seed() const { return end_; }
  [[nodiscard]] std::uint64_t count() const { return end_ - first_; }

 private:
  std::uint64_t first_ = 1;
  std::uint64_t end_ = 1;
};

/// Some failed seeds teach more than one; hundreds teach nothing more.
[[nodiscard]] inline bool too_many_failures() {
  const char* const most = std::getenv("KERFLINE_FAILURES");
  const int enough = most != nullptr ? std::stoi(most) : 20;
  const auto* const info = testing::UnitTest::GetInstance()->current_test_info();
  return info->result()->total_part_count() >= enough;
}

}  // namespace proof
