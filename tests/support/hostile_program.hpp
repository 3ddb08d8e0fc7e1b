#pragma once

#include <string>
#include <utility>
#include <vector>

#include "tests/support/random_source.hpp"

namespace proof {

/// A random job of coherent G-code, from a nanometre to half a kilometre in size, with settings of
/// any value that the firmware accepts. It contains large circles with near ends, tiny elements
/// after long ones, cutter compensation and splines.
struct HostileJob {
  /// Numbers and values of settings; the controller may refuse some.
  std::vector<std::pair<int, double>> settings;
  std::vector<std::string> lines;  ///< Lines of G-code; the controller may refuse some.

  explicit HostileJob(Random& random);
};

}  // namespace proof
