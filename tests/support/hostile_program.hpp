#pragma once

#include <string>
#include <utility>
#include <vector>

#include "tests/support/random_source.hpp"

namespace proof {

/// Lines of G-code that make sense together at any size, from a nanometre to half a kilometre, and
/// settings of any value that the firmware takes: large circles with near ends, tiny elements after
/// long ones, cutter compensation, splines.
struct HostileJob {
  std::vector<std::pair<int, double>> settings;  ///< Number and value; some may be refused.
  std::vector<std::string> lines;                ///< Some may be refused.

  explicit HostileJob(Random& random);
};

}  // namespace proof
