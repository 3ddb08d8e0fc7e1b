#pragma once

#include <cstdint>

/// Digest of all edges of a fixed program.
struct Digest {
  std::uint64_t hash = 14695981039346656037ULL;  ///< FNV-1a over all edges.
  std::uint32_t edges = 0;
  std::uint32_t answers = 0;

  void add(std::uint32_t value) {
    for (int byte = 0; byte < 4; ++byte) {
      hash = (hash ^ (value >> (8 * byte) & 0xFFU)) * 1099511628211ULL;
    }
  }
};

/// Runs the complete firmware in virtual time on a program that it generates: lines, arcs and
/// helices in all planes, short segments, dwells, powers, shapers and backlash.
[[nodiscard]] Digest digest_of_a_job();
