#pragma once

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <iterator>
#include <string_view>
#include <vector>

namespace proof {

/// Returns KERFLINE_TRIALS if set, else `usual` limited to KERFLINE_MOST_TRIALS, which shortens
/// tests and lengthens none.
[[nodiscard]] std::uint64_t trials_wanted(std::uint64_t usual);

/// Returns the seed at which the range of a test begins: 1 without a base, else 1 to 4·10⁹ by a
/// hash of both (FNV-1a, then the finalizer of SplitMix64). Seeds and trials fit into 32 bits.
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
    /// The range from seed 1 unless KERFLINE_TIER=seeds, which is the last step of prove.sh: for
    /// tests of a property that a known fault violates at about one in some hundred new seeds.
    kKnownFault,
    /// Always the range from seed 1: for a share of the trials, which other samples exceed by
    /// chance.
    kFixed,
  };

  /// @pre A test is running. Reads the seed file; a fault in it is a failure of the test.
  explicit Trials(std::uint64_t usual, Range range = Range::kFromBase);

  class Iterator {
   public:
    Iterator(const Trials& trials, std::uint64_t index) : trials_{&trials}, index_{index} {}
    /// Returns the seed and notes it as the one that a failure reports.
    std::uint64_t operator*() const;
    Iterator& operator++() {
      ++index_;
      return *this;
    }
    /// Returns whether the loop ends: all seeds are tried, or too many have failed.
    bool operator==(std::default_sentinel_t) const;

   private:
    const Trials* trials_;
    std::uint64_t index_;
  };

  [[nodiscard]] Iterator begin() const { return {*this, 0}; }
  [[nodiscard]] std::default_sentinel_t end() const { return {}; }
  /// Returns whether the range has at least its usual length. Only then a test judges a share of
  /// the trials, or how many of them met a case: three trials may meet none at all.
  [[nodiscard]] bool judges_shares() const { return random_count_ >= usual_; }
  /// Number of seeds, those that once failed included.
  [[nodiscard]] std::uint64_t count() const { return once_failed_.size() + random_count_; }

 private:
  std::vector<std::uint64_t> once_failed_;
  std::uint64_t usual_ = 0;
  std::uint64_t first_ = 1;
  std::uint64_t random_count_ = 0;
};

/// Returns the first seed of the running test, for a test that draws all its inputs from one
/// stream of random numbers. A seed that fails needs a loop over Trials to be kept in a file.
[[nodiscard]] std::uint64_t test_seed();

/// Returns whether a case of a table is tried: in toolchain/test.sh one of `stride` neighbours,
/// another one with another base of seeds; else all.
[[nodiscard]] bool is_in_share(std::size_t index, std::size_t stride);

/// Returns whether the running test has failed 20 times (KERFLINE_FAILURES): some failed seeds
/// teach more than one, hundreds teach nothing more.
[[nodiscard]] bool too_many_failures();

}  // namespace proof
