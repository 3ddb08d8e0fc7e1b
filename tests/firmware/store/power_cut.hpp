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
/// What must be in the store.
using Values = std::map<std::uint16_t, Value>;

/// A save that may or may not have happened.
struct Doubt {
  std::uint16_t number = 0;
  Value value;
};

/// All records of a log, found both ways: by going from number to number and by asking.
[[nodiscard]] Values all_of(FlashLog& log);

/// A script of saves on one log, with the power cut at each operation of flash in a copy, booted
/// from there, and again at each operation of that recovery.
struct PowerCutTrial {
  hal::host::CutKind kind = hal::host::CutKind::kBefore;
  std::size_t words = 128;
  int saves = 1000;
  std::uint64_t every = 1;   ///< One operation of so many is cut.
  int cuts_of_recovery = 1;  ///< How many cuts follow the first, each in the recovery before it.
  std::uint64_t seed = 1;
};

struct PowerCutCount {
  std::uint64_t operations = 0;  ///< Of the script.
  std::uint64_t erases = 0;
  std::uint64_t cuts = 0;
  std::uint64_t appeared = 0;  ///< Saves that nobody had been told of, and that are there.
};

/// Fails the running test at the first value that is not what it must be.
[[nodiscard]] PowerCutCount run(const PowerCutTrial& trial);

}  // namespace cnc
