#include "tests/target/machine/can_filters.hpp"

namespace machine {
namespace {

constexpr std::uint32_t kMaster = 0x200, kLists = 0x204, kWide = 0x20C, kFifos = 0x214;
constexpr std::uint32_t kActive = 0x21C, kFirstBank = 0x240, kEnd = 0x320;
constexpr std::uint32_t kAfterReset = 0x2A1C'0E01;

/// Returns the frame as a 32-bit filter sees it: STID, EXID, IDE, RTR, 0.
std::uint32_t wide_word(const CanFrame& frame) {
  const std::uint32_t id = frame.extended ? frame.id << 3U : frame.id << 21U;
  return id | (frame.extended ? 4U : 0U) | (frame.remote ? 2U : 0U);
}

/// Returns the frame as a 16-bit filter sees it: STID, RTR, IDE, EXID bits 17 to 15.
std::uint32_t narrow_word(const CanFrame& frame) {
  const std::uint32_t base = frame.extended ? frame.id >> 18U : frame.id;
  const std::uint32_t rest = frame.extended ? frame.id >> 15U & 7U : 0;
  return base << 5U | (frame.remote ? 0x10U : 0U) | (frame.extended ? 8U : 0U) | rest;
}

}  // namespace

void CanFilters::reset() {
  master_ = kAfterReset;
  lists_ = wide_ = fifos_ = active_ = 0;
}

std::uint32_t CanFilters::read(std::uint32_t offset) const {
  switch (offset) {
    case kMaster:
      return master_;
    case kLists:
      return lists_;
    case kWide:
      return wide_;
    case kFifos:
      return fifos_;
    case kActive:
      return active_;
    default:
      break;
  }
  if (offset < kFirstBank || offset >= kEnd) return 0;
  return banks_[(offset - kFirstBank) / 8][offset / 4 % 2];
}

void CanFilters::write(std::uint32_t offset, std::uint32_t value) {
  constexpr std::uint32_t kAllBanks = 0x0FFF'FFFF;
  const bool setting_up = (master_ & 1U) != 0;
  if (offset == kMaster) master_ = kAfterReset - 0xE01U + (value & 0x3F01U);
  if (offset == kActive) active_ = value & kAllBanks;
  if (setting_up && offset == kLists) lists_ = value & kAllBanks;
  if (setting_up && offset == kWide) wide_ = value & kAllBanks;
  if (setting_up && offset == kFifos) fifos_ = value & kAllBanks;
  if (offset < kFirstBank || offset >= kEnd) return;
  const std::uint32_t bank = (offset - kFirstBank) / 8;
  // A bank's values can be changed only while the bank is not active.
  if (setting_up || !bit(active_, bank)) banks_[bank][offset / 4 % 2] = value;
}

unsigned CanFilters::filters_of(unsigned bank) const {
  return (bit(wide_, bank) ? 1U : 2U) * (bit(lists_, bank) ? 2U : 1U);
}

bool CanFilters::passes(unsigned bank, unsigned filter, const CanFrame& frame) const {
  const auto& words = banks_[bank];
  if (bit(wide_, bank)) {
    const std::uint32_t word = wide_word(frame);
    return bit(lists_, bank) ? word == words[filter] : ((word ^ words[0]) & words[1]) == 0;
  }
  const std::uint32_t word = narrow_word(frame);
  if (bit(lists_, bank)) return word == (words[filter / 2] >> filter % 2 * 16 & 0xFFFFU);
  return ((word ^ words[filter]) & words[filter] >> 16U & 0xFFFFU) == 0;
}

std::optional<CanFilters::Passed> CanFilters::pass(const CanFrame& frame) const {
  if ((master_ & 1U) != 0) return std::nullopt;
  const std::uint32_t banks_of_first = master_ >> 8U & 0x3FU;
  std::array<std::uint32_t, 2> index{};
  std::optional<Passed> best;
  unsigned best_rank = 0;
  for (unsigned bank = 0; bank < banks_of_first && bank < kBanks; ++bank) {
    const unsigned fifo = bit(fifos_, bank) ? 1 : 0;
    // Priority: wide filters before narrow ones, then lists before masks, then the lower number.
    const unsigned rank = (bit(wide_, bank) ? 2U : 0U) + (bit(lists_, bank) ? 1U : 0U) + 1;
    for (unsigned filter = 0; filter < filters_of(bank); ++filter, ++index[fifo]) {
      if (!bit(active_, bank) || rank <= best_rank || !passes(bank, filter, frame)) continue;
      best = Passed{fifo, index[fifo]};
      best_rank = rank;
    }
  }
  return best;
}

}  // namespace machine
