#include "host-sim/measure/difference_meter.hpp"

#include <algorithm>

namespace sim {
namespace {

constexpr std::size_t kHighestOrder = 3;

/// Returns the least |value| within the interval of order! · f[t0 … tn].
double min_difference(const std::array<const AxisFix*, kHighestOrder + 1>& fixes,
                      std::size_t order) {
  double low = 0.0;
  double high = 0.0;
  for (std::size_t i = 0; i <= order; ++i) {
    double weight = 1.0;
    for (std::size_t j = 0; j <= order; ++j) {
      if (j != i) weight /= fixes[i]->time_s - fixes[j]->time_s;
    }
    for (std::size_t factor = 2; factor <= order; ++factor) weight *= static_cast<double>(factor);
    low += weight * (weight > 0.0 ? fixes[i]->low : fixes[i]->high);
    high += weight * (weight > 0.0 ? fixes[i]->high : fixes[i]->low);
  }
  return std::max({0.0, low, -high});
}

}  // namespace

const AxisFix& DifferenceMeter::fix(std::size_t age) const {
  return fixes_[(count_ - 1 - age) % kCapacity];
}

void DifferenceMeter::add_edge(double time_s, double position, double low, double high) {
  const double before = time_s - window_s_;
  if (!latest_) {
    add({before, low, high});
  } else if (const double after = latest_->time_s + window_s_; after <= before) {
    add({after, low, high});
    if (after < before) add({before, low, high});
  }
  add({time_s, position, position});
}

void DifferenceMeter::finish(double low, double high) {
  if (!latest_) return;
  add({latest_->time_s + window_s_, low, high});
  settle_latest();
}

void DifferenceMeter::add(const AxisFix& fix) {
  const double spacing = window_s_ / kFixesPerWindow;
  if (latest_ && (count_ == 0 || fix.time_s - this->fix(0).time_s >= spacing)) settle_latest();
  latest_ = fix;
}

void DifferenceMeter::settle_latest() {
  ++count_;
  fixes_[(count_ - 1) % kCapacity] = *latest_;
  measure(false);
  if (latest_->exact()) measure(true);
}

std::optional<std::size_t> DifferenceMeter::window_before(std::size_t age, bool exact_only) const {
  // Because of rounding, the age of a fix that is exactly a window older may seem to be less than a
  // window.
  const double least = window_s_ * (1.0 - 1.0e-6);
  const std::size_t kept = std::min(count_, kCapacity);
  for (std::size_t older = age + 1; older < kept; ++older) {
    if (exact_only && !fix(older).exact()) continue;
    if (fix(age).time_s - fix(older).time_s >= least) return older;
  }
  return std::nullopt;
}

void DifferenceMeter::measure(bool exact_only) {
  std::array<const AxisFix*, kHighestOrder + 1> chosen{&fix(0)};
  std::size_t age = 0;
  for (std::size_t i = 1; i <= order_; ++i) {
    const auto older = window_before(age, exact_only);
    if (!older) return;
    age = *older;
    chosen[i] = &fix(age);
  }
  const double value = min_difference(chosen, order_);
  if (value <= greatest_) return;
  greatest_ = value;
  time_s_ = chosen[0]->time_s;
}

}  // namespace sim
