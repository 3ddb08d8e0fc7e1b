#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <random>
#include <vector>

#include "firmware/store/flash_log.hpp"
#include "hal/host/flash_model.hpp"

namespace cnc {

using Value = std::vector<std::byte>;
/// Values that must be in the store, by number.
using Values = std::map<std::uint16_t, Value>;

/// A save that may or may not have been completed.
struct Doubt {
  std::uint16_t number = 0;
  Value value;
};

/// Returns all records of a log, after reading it in two ways: by iterating over the numbers and by
/// requesting each number.
[[nodiscard]] Values all_of(FlashLog& log);

/// A script of saves on one log. In a copy, the power is cut at each flash operation, and the copy
/// is booted. In this recovery, too, the power is cut at each operation.
struct PowerCutTrial {
  hal::host::CutKind kind = hal::host::CutKind::kBefore;
  std::size_t words = 128;
  int saves = 1000;
  std::uint64_t every = 1;   ///< The power is cut at one of `every` operations.
  int cuts_of_recovery = 1;  ///< Number of cuts that follow the first one, each in the recovery
                             ///< from the one before.
  std::uint64_t seed = 1;
};

struct PowerCutCount {
  std::uint64_t operations = 0;  ///< Flash operations of the script.
  std::uint64_t erases = 0;
  std::uint64_t cuts = 0;
  std::uint64_t appeared = 0;  ///< Saves that were not acknowledged, but are in the store.
};

/// Runs the trial, and fails the running test at the first wrong value.
[[nodiscard]] PowerCutCount run(const PowerCutTrial& trial);

}  // namespace cnc
