#pragma once

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <iterator>
#include <string_view>
#include <vector>

namespace proof {

/// Returns KERFLINE_TRIALS if set, else `usual` limited to KERFLINE_MOST_TRIALS. That limit
/// shortens tests, but never lengthens one.
[[nodiscard]] std::uint64_t trials_wanted(std::uint64_t usual);

/// Returns the seed at which the range of a test begins: 1 without a base, else 1 to 4·10⁹ by a
/// hash of base and test (FNV-1a, then the finalizer of SplitMix64). Seeds plus trials fit into 32
/// bits.
[[nodiscard]] std::uint64_t first_seed_of(std::string_view base, std::string_view test);

/// Seeds of a property test:
///   for (const std::uint64_t seed : Trials{1000}) { … }
/// First come the seeds that once failed, from the file beside the test's source (seed_file.hpp),
/// then the random range. Each test names the number of trials that takes it about half a minute
/// in a release build. The loop ends early if too many trials have failed.
///
/// KERFLINE_SEED_BASE (the commit, set by the test scripts) chooses the range;
/// KERFLINE_TRIALS=100000 lengthens it; KERFLINE_SEED=<seed> runs that seed alone, or as many as
/// KERFLINE_TRIALS from it. A failure prints the command that repeats it.
class Trials {
 public:
  enum class Range {
    kFromBase,
    /// The range begins at seed 1, except in the last step of prove.sh (KERFLINE_TIER=seeds). For
    /// tests of a property that a known fault violates at about one in some hundred new seeds.
    kKnownFault,
    /// The range always begins at seed 1. For tests of a share of the trials, which other samples
    /// would exceed by chance.
    kFixed,
  };

  /// Reads the seed file; a fault in it is a failure of the test. @pre A test is running.
  explicit Trials(std::uint64_t usual, Range range = Range::kFromBase);

  class Iterator {
   public:
    Iterator(const Trials& trials, std::uint64_t index) : trials_{&trials}, index_{index} {}
    /// Returns the present seed, and stores it as the seed that a failure reports.
    std::uint64_t operator*() const;
    Iterator& operator++() {
      ++index_;
      return *this;
    }
    /// Returns whether the loop ends: all seeds have been tried, or too many have failed.
    bool operator==(std::default_sentinel_t) const;

   private:
    const Trials* trials_;
    std::uint64_t index_;
  };

  [[nodiscard]] Iterator begin() const { return {*this, 0}; }
  [[nodiscard]] std::default_sentinel_t end() const { return {}; }
  /// Returns whether the range has at least its usual length. Only then a test judges shares of the
  /// trials, or the number of trials with a certain case: three trials may contain no such case.
  [[nodiscard]] bool judges_shares() const { return random_count_ >= usual_; }
  /// Returns the number of seeds, including the seeds that once failed.
  [[nodiscard]] std::uint64_t count() const { return once_failed_.size() + random_count_; }

 private:
  std::vector<std::uint64_t> once_failed_;
  std::uint64_t usual_ = 0;
  std::uint64_t first_ = 1;
  std::uint64_t random_count_ = 0;
};

/// Returns the first seed of the running test, for a test that draws all its inputs from one stream
/// of random numbers. To keep a failed seed in a file, a test requires a loop over Trials.
[[nodiscard]] std::uint64_t test_seed();

/// Returns whether a case of a table is tried. In toolchain/test.sh it is one of `stride`
/// successive cases, which the base of seeds chooses; elsewhere it is every case.
[[nodiscard]] bool is_in_share(std::size_t index, std::size_t stride);

/// Returns whether the running test has failed 20 times (KERFLINE_FAILURES). A few failed seeds
/// help to find the fault; hundreds add nothing.
[[nodiscard]] bool too_many_failures();

}  // namespace proof
