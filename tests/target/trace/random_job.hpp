#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tests/target/trace/timed_sender.hpp"

namespace trace {

/// A program for a machine, and the actions of its operator.
struct Job {
  std::string settings;  ///< Lines `$N=value`.
  std::string program;   ///< Lines, each with its line end.
  std::vector<Injection> injections;
};

/// Returns any machine, and any program of the random corpus as G-code: lines, arcs, helices,
/// rapids, stops, splines and rows of pixels. Feed holds with their resumes, and overrides, come in
/// any cycle from `first_turn` on.
[[nodiscard]] Job random_job(std::uint64_t seed, std::uint32_t first_turn);

}  // namespace trace
