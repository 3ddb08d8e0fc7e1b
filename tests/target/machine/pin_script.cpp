#include "tests/target/machine/pin_script.hpp"

#include <fmt/core.h>

#include <cstdio>
#include <fstream>
#include <sstream>

namespace machine {
namespace {

bool read_change(const std::string& line, PinChange& change) {
  std::istringstream words{line};
  std::string rest;
  char p = 0, level = 0;
  words >> change.at_ns >> p >> change.port >> change.pin >> level;
  if (!words || words >> rest || p != 'P' || change.port < 'A' || change.port > 'I') return false;
  if (change.pin >= Gpio::kPins || (level != '0' && level != '1' && level != 'z')) return false;
  change.wire = level == '0' ? Gpio::Wire::kLow : Gpio::Wire::kHigh;
  if (level == 'z') change.wire = Gpio::Wire::kFree;
  return true;
}

}  // namespace

bool read_pin_script(const std::string& path, std::vector<PinChange>& changes) {
  std::ifstream file{path};
  if (!file) {
    fmt::print(stderr, "machine: cannot read {}\n", path);
    return false;
  }
  std::string line;
  for (int number = 1; std::getline(file, line); ++number) {
    PinChange change;
    const bool good = read_change(line, change);
    if (!good || (!changes.empty() && change.at_ns < changes.back().at_ns)) {
      fmt::print(stderr, "machine: {}:{}: not a change of a pin, or not later\n", path, number);
      return false;
    }
    changes.push_back(change);
  }
  return true;
}

}  // namespace machine
