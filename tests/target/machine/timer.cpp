#include "tests/target/machine/timer.hpp"

#include <algorithm>
#include <limits>
#include <string>

namespace machine {
namespace {

// Offsets of the registers.
constexpr std::uint32_t kControl = 0x00, kSlave = 0x08, kEnables = 0x0C, kStatus = 0x10;
constexpr std::uint32_t kGeneration = 0x14, kModes1 = 0x18, kOutputs = 0x20, kCount = 0x24;
constexpr std::uint32_t kPrescaler = 0x28, kReload = 0x2C, kRepetition = 0x30;
constexpr std::uint32_t kCompare1 = 0x34, kCompare4 = 0x40, kBreak = 0x44, kOption = 0x50;
// CR1
constexpr std::uint32_t kUpdateDisable = 2, kOnlyOverflow = 4, kOnePulse = 8;
constexpr std::uint32_t kNotModelled = 0x70, kReloadPreload = 0x80;
constexpr std::uint32_t kUpdate = 1;  // UIF, UIE, UG
constexpr std::uint32_t kMatches = 0x1E;

constexpr std::int64_t kNoEvent = std::numeric_limits<std::int64_t>::max();

}  // namespace

Timer::Timer(const Services& services, const TimerKind& kind)
    : Peripheral{services, kind.place},
      kind_{kind},
      widest_{kind.is_wide ? 0xFFFF'FFFFU : 0xFFFFU},
      update_line_{services.interrupts, kind.update_interrupt},
      compare_line_{services.interrupts, kind.compare_interrupt},
      alarm_{[this] {
        advance();
        settle();
      }} {}

void Timer::reset() {
  alarm_.cancel();
  kept_.fill(0);
  control_ = enables_ = flags_ = 0;
  prescaler_ = prescaler_preload_ = 0;
  reload_ = reload_preload_ = widest_;
  misses_reload_ = false;
  place_ = 0;
  for (Channel& channel : channels_) channel.compare = channel.preload = 0;
  settle();
}

Timer::Ticks Timer::clock() const {
  return static_cast<Ticks>(static_cast<__int128>(now_ns()) * clocks().timer_hz(kind_.bus) /
                            kSecond_ns);
}

std::int64_t Timer::ns_of(Ticks ticks) const {
  const __int128 hz = clocks().timer_hz(kind_.bus);
  return static_cast<std::int64_t>((static_cast<__int128>(ticks) * kSecond_ns + hz - 1) / hz);
}

void Timer::before_clock_change() {
  advance();
  if (counting()) place_ = clock() - origin_;
}

void Timer::after_clock_change() {
  if (counting()) set_place(place_);
  settle();
}

std::uint32_t Timer::count() const {
  const Ticks place = counting() ? clock() - origin_ : place_;
  return static_cast<std::uint32_t>(place / step()) & widest_;
}

Timer::Ticks Timer::overflow() const {
  return origin_ + (misses_reload_ ? (Ticks{widest_} + 1) * step() : period());
}

void Timer::set_place(Ticks place) {
  place_ = place;
  origin_ = clock() - place;
  seen_ = clock() - 1;  // One less, so that a compare value equal to the present count matches.
}

void Timer::set_counting(bool on) {
  if (on == counting()) return;
  if (!on) place_ = clock() - origin_;
  control_ ^= 1U;
  if (!on) return;
  set_place(place_);
  if (trace().follows_words()) trace().event("counts", "{} {}", place().name, count());
}

void Timer::note_matches(Ticks until) {
  for (unsigned i = 0; i < kind_.channels; ++i) {
    const Ticks at = origin_ + Ticks{channels_[i].compare} * step();
    if (seen_ < at && at <= until && at < overflow()) flags_ |= 2U << i;
  }
  seen_ = until;
}

void Timer::load_preloaded() {
  prescaler_ = prescaler_preload_;
  reload_ = reload_preload_;
  for (Channel& channel : channels_) channel.compare = channel.preload;
}

void Timer::wrap(Ticks at) {
  origin_ = at;
  if (misses_reload_) {  // An overflow at the widest value causes no update.
    misses_reload_ = false;
    return;
  }
  if ((control_ & kUpdateDisable) == 0) {
    flags_ |= kUpdate;
    load_preloaded();
  }
  if ((control_ & kOnePulse) != 0) {
    control_ &= ~1U;
    place_ = 0;
  }
}

void Timer::advance() {
  // Two overflows are processed singly, because preloaded values apply from the first one on. All
  // later periods are the same.
  for (int passes = 0; passes < 2 && counting() && !blocked(); ++passes) {
    const Ticks at = overflow();
    if (at > clock()) break;
    note_matches(at - 1);
    wrap(at);
  }
  if (!counting() || blocked()) return;
  if (const Ticks periods = (clock() - origin_) / period(); periods > 0 && !misses_reload_) {
    note_matches(origin_ + period() - 1);
    origin_ += periods * period();
    if ((control_ & kUpdateDisable) == 0) flags_ |= kUpdate;
    seen_ = origin_ - 1;
  }
  note_matches(clock());
}

bool Timer::preload_waits() const {
  for (unsigned i = 0; i < kind_.channels; ++i) {
    if (channels_[i].compare != channels_[i].preload) return true;
  }
  return prescaler_ != prescaler_preload_ || reload_ != reload_preload_;
}

Timer::Ticks Timer::next_event() const {
  if (!counting() || blocked()) return kNoEvent;
  Ticks next = kNoEvent;
  const bool interrupts = (enables_ & ~flags_ & kUpdate) != 0;
  if (interrupts || preload_waits() || (control_ & kOnePulse) != 0) next = overflow();
  for (unsigned i = 0; i < kind_.channels; ++i) {
    if ((enables_ & ~flags_ & 2U << i) == 0 || channels_[i].compare > reload_) continue;
    Ticks at = origin_ + Ticks{channels_[i].compare} * step();
    if (at <= seen_) at += overflow() - origin_;
    next = std::min(next, at);
  }
  return next;
}

void Timer::settle() {
  const bool updated = (flags_ & enables_ & kUpdate) != 0;
  const bool matched = (flags_ & enables_ & kMatches) != 0;
  update_line_.set(updated);
  compare_line_.set(matched);
  for (unsigned i = 0; i < kind_.channels; ++i) {
    const Course course = course_of(i);
    if (course == channels_[i].course) continue;
    channels_[i].course = course;
    std::string text{course.kind};
    if (course.kind == 'p') {
      text = fmt::format("{}/{} {}", course.on, course.period, clocks().timer_hz(kind_.bus));
    }
    trace().event("pwm", "{}_CH{} {}", place().name, i + 1, text);
  }
  const Ticks next = next_event();
  if (next == kNoEvent) {
    alarm_.cancel();
  } else {
    alarm_.set(ns_of(next));
  }
}

std::uint32_t Timer::mode_bits(unsigned index) const {
  return field(kept_[(kModes1 + index / 2 * 4) / 4], index % 2 * 8, 8);
}

Timer::Course Timer::course_of(unsigned index) const {
  constexpr std::uint32_t kInactive = 4, kActive = 5, kPwm1 = 6, kPwm2 = 7;
  const std::uint32_t output = field(kept_[kOutputs / 4], 4 * index, 4);
  const bool let_out = !kind_.has_break || field(kept_[kBreak / 4], 15, 1) != 0;
  if ((output & 1U) == 0 || !let_out) return {};
  const bool inverted = (output & 2U) != 0;
  const std::uint32_t mode = field(mode_bits(index), 4, 3);
  const Ticks compare = channels_[index].compare;
  Ticks on = mode == kActive ? period() : 0;
  if (mode == kPwm1 || mode == kPwm2) {
    on = std::min(compare * step(), period());
    // A stopped counter keeps the level that belongs to its count.
    if (!counting() || blocked()) on = count() < compare ? period() : 0;
    if (mode == kPwm2) on = period() - on;
  } else if (mode != kInactive && mode != kActive) {
    // Frozen or changed by matches: the output stays as after reset, because matches do not change
    // outputs in this model.
    on = 0;
  }
  if (inverted) on = period() - on;
  if (on == 0) return {'0', 0, 0};
  return on == period() ? Course{'1', 0, 0} : Course{'p', on, period()};
}

std::uint32_t Timer::read(std::uint32_t offset) {
  advance();
  if (offset >= kCompare1 && offset <= kCompare4) {
    return channels_[(offset - kCompare1) / 4].preload;
  }
  switch (offset) {
    case kControl:
      return control_;
    case kEnables:
      return enables_;
    case kStatus:
      return flags_;
    case kCount:
      return count();
    case kPrescaler:
      return prescaler_preload_;
    case kReload:
      return reload_preload_;
    default:
      return offset <= kOption && offset != kGeneration ? kept_[offset / 4] : 0;
  }
}

void Timer::write(std::uint32_t offset, std::uint32_t value) {
  advance();
  if (offset >= kCompare1 && offset <= kCompare4) {
    write_compare((offset - kCompare1) / 4, value & widest_);
  } else if (offset == kControl) {
    write_control(value);
  } else if (offset == kEnables) {
    not_modelled(offset, value & ~(kUpdate | kMatches));
    enables_ = value & (kUpdate | kMatches);
  } else if (offset == kStatus) {
    flags_ &= value;
  } else if (offset == kGeneration) {
    generate(value);
  } else if (offset == kCount) {
    set_place(Ticks{value & widest_} * step());
    misses_reload_ = (value & widest_) > reload_;
  } else if (offset == kPrescaler) {
    prescaler_preload_ = value & 0xFFFFU;
  } else if (offset == kReload) {
    write_reload(value & widest_);
  } else if (offset <= kOption) {
    if (offset == kSlave || offset == kRepetition) not_modelled(offset, value);
    if (offset == kModes1 || offset == kModes1 + 4) not_modelled(offset, value & 0x0303U);
    kept_[offset / 4] = value;
  }
  settle();
}

void Timer::write_control(std::uint32_t value) {
  not_modelled(kControl, value & kNotModelled);
  const bool on = (value & 1U) != 0;
  set_counting(on);
  control_ = (value & 0x38EU) | (on ? 1U : 0U);
}

void Timer::write_compare(unsigned index, std::uint32_t value) {
  if (index >= kind_.channels) return;
  Channel& channel = channels_[index];
  channel.preload = value;
  const bool drives_pin = field(kept_[kOutputs / 4], 4 * index, 1) != 0;
  if (trace().follows_words()) {
    trace().tell_words();
    if (drives_pin) trace().event("compare", "{}_CH{} {}", place().name, index + 1, value);
  }
  if ((mode_bits(index) & 8U) != 0) return;
  channel.compare = value;
  if (counting() && value == count()) flags_ |= 2U << index;
}

void Timer::write_reload(std::uint32_t value) {
  reload_preload_ = value;
  if ((control_ & kReloadPreload) != 0) return;
  const bool was_blocked = blocked();
  if (counting() && was_blocked) place_ = 0;
  reload_ = value;
  if (counting() && was_blocked) set_place(0);
  misses_reload_ = count() > reload_;
}

void Timer::generate(std::uint32_t events) {
  if ((events & kUpdate) != 0) {
    const bool enabled = (control_ & kUpdateDisable) == 0;
    if (enabled) load_preloaded();
    if (enabled && (control_ & kOnlyOverflow) == 0) flags_ |= kUpdate;
    misses_reload_ = false;
    set_place(0);
  }
  flags_ |= events & kMatches & ((2U << kind_.channels) - 1U);
}

}  // namespace machine
