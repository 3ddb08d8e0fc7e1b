#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace proof {

/// Seeds that once failed, by test. The file of limits_test.cpp is limits_test.seeds in the same
/// folder:
///   # A comment.
///   [RandomPrograms.KeepEveryLimit]
///   34923  # Reason: what failed with this seed.
/// The section is the full name of a test. Every seed requires a reason.
struct SeedFile {
  std::map<std::string, std::vector<std::uint64_t>> seeds;
  /// Faults of the text, each with its line.
  std::vector<std::string> faults;
};

/// Reads the text of a seed file. Reports as faults: empty sections, seeds without a section or a
/// reason, seeds or sections that occur twice, and lines of any other form.
[[nodiscard]] SeedFile read_seeds(std::string_view text);

}  // namespace proof
