#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace proof {

/// Seeds that once failed, by test. They stand in limits_test.seeds beside limits_test.cpp:
///   # A comment.
///   [RandomPrograms.KeepEveryLimit]
///   34923  # Reason: what failed with this seed.
/// The section is the full name of a test; every seed has its reason.
struct SeedFile {
  std::map<std::string, std::vector<std::uint64_t>> seeds;
  /// What is wrong with the text, each with its line.
  std::vector<std::string> faults;
};

/// Reads the text of a seed file. Empty sections, seeds without a section or a reason, seeds and
/// sections that occur twice, and lines of any other form are faults.
[[nodiscard]] SeedFile read_seeds(std::string_view text);

}  // namespace proof
