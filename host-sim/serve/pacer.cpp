#include "host-sim/serve/pacer.hpp"

#include <algorithm>

namespace sim {
namespace {

using Seconds = std::chrono::duration<double>;
constexpr double kTurnsPerSecond = 1000.0;

}  // namespace

double Pacer::turns_at(Clock::time_point now) const {
  return Seconds{now - start_}.count() * speed_ * kTurnsPerSecond;
}

std::uint64_t Pacer::take_due(Clock::time_point now) {
  const auto wanted = static_cast<std::uint64_t>(std::max(0.0, turns_at(now)));
  if (wanted <= done_) return 0;
  const double max_behind = Seconds{kMaxBehind}.count() * speed_ * kTurnsPerSecond;
  const std::uint64_t kept = std::max(kMaxTurns, static_cast<std::uint64_t>(max_behind));
  if (wanted - done_ > kept) {
    // Moves `start_` so that the time since `start_` equals the kept backlog.
    const Seconds backlog{static_cast<double>(kept) / (speed_ * kTurnsPerSecond)};
    start_ = now - std::chrono::duration_cast<Clock::duration>(backlog);
    done_ = 0;
    done_ = kMaxTurns;
    return done_;
  }
  const std::uint64_t turns = std::min(wanted - done_, kMaxTurns);
  done_ += turns;
  return turns;
}

Pacer::Clock::duration Pacer::until_next(Clock::time_point now) const {
  const Seconds next{static_cast<double>(done_ + 1) / (speed_ * kTurnsPerSecond)};
  const auto due = start_ + std::chrono::ceil<Clock::duration>(next);
  return std::max(due - now, Clock::duration::zero());
}

}  // namespace sim
