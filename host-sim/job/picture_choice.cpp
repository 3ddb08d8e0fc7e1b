#include "host-sim/job/picture_choice.hpp"

#include <algorithm>
#include <limits>
#include <set>

namespace sim {

bool is_mill(const cnc::Settings& settings) {
  return settings.get(cnc::setting::kLaserMode) == 0.0F;
}

Shown shown_of(const ProgrammedPath& path, const cnc::Settings& settings) {
  // Number of different powers above which a program counts as a relief. A sheet that is cut,
  // scored and engraved has only three powers.
  constexpr std::size_t kPowersOfARelief = 8;
  constexpr std::size_t kZ = 2;
  std::set<double> powers;
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (const PathPiece& piece : path.pieces) {
    const bool cuts = piece.travel == Travel::kFeed && piece.spindle != SpindleState::kOff &&
                      piece.spindle_speed > 0.0;
    if (!cuts) continue;
    const auto bounds = piece.curve.bounds();
    low = std::min(low, bounds.low[kZ]);
    high = std::max(high, bounds.high[kZ]);
    if (powers.size() <= kPowersOfARelief) powers.insert(piece.spindle_speed);
  }
  if (is_mill(settings)) return low < high ? Shown::kDepth : Shown::kSpeed;
  return powers.size() > kPowersOfARelief ? Shown::kPower : Shown::kSpeed;
}

}  // namespace sim
