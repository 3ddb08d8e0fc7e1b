#pragma once

#include <string>
#include <vector>

namespace proof {

/// A program by lines, cut at up to 200 mm/s. A path never comes within 0.3 mm of itself, except
/// where it closes.
struct DoorJob {
  const char* name;
  std::vector<std::string> lines;
};

/// Returns jobs of corners, of arcs, of chords, of pixels, and one offset from its contour.
[[nodiscard]] std::vector<DoorJob> door_jobs();

}  // namespace proof
