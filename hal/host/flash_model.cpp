#include "hal/host/flash_model.hpp"

#include <array>
#include <random>
#include <stdexcept>

namespace hal::host {
namespace {

/// Returns 32 random bits for a seed, by the mixing function of SplitMix64.
std::uint32_t coins(std::uint64_t seed) {
  seed += 0x9E37'79B9'7F4A'7C15;
  seed = (seed ^ (seed >> 30)) * 0xBF58'476D'1CE4'E5B9;
  seed = (seed ^ (seed >> 27)) * 0x94D0'49BB'1331'11EB;
  return static_cast<std::uint32_t>((seed ^ (seed >> 31)) >> 16);
}

constexpr unsigned kMoods = 5;

/// Effect of a power cut on the bits that the operation changes: bits that changed, and bits that
/// are unsteady.
struct Tear {
  std::uint32_t changed;
  std::uint32_t unsteady;
};

/// Returns the effect of a random cut. `mood` selects the moment of the cut within the operation:
/// few, most, half or all of the bits have changed.
Tear tear(std::mt19937_64& random, CutKind kind, unsigned mood) {
  const auto word = [&random] { return static_cast<std::uint32_t>(random()); };
  const auto few = [&word] {
    std::uint32_t bits = word();
    for (int i = 0; i < 3; ++i) bits &= word();
    return bits;
  };
  const std::array<std::uint32_t, kMoods> most{few(), ~few(), word(), few(), ~0U};
  const std::array<std::uint32_t, kMoods> between{few(), few(), word(), ~0U, few()};
  return {.changed = most[mood], .unsteady = kind == CutKind::kMarginal ? between[mood] : 0U};
}

}  // namespace

FlashModel::FlashModel(std::size_t sectors, std::size_t words)
    : sectors_{sectors}, words_{words}, memory_(sectors * words), erases_(sectors) {}

const FlashModel::Word& FlashModel::at(std::size_t sector, std::size_t word) const {
  if (sector >= sectors_ || word >= words_) throw std::out_of_range("beyond the flash");
  return memory_[sector * words_ + word];
}

FlashModel::Word& FlashModel::at(std::size_t sector, std::size_t word) {
  if (sector >= sectors_ || word >= words_) throw std::out_of_range("beyond the flash");
  return memory_[sector * words_ + word];
}

std::uint32_t FlashModel::read(std::size_t sector, std::size_t word) const {
  const Word& read = at(sector, word);
  if (read.unsteady == 0) return read.bits;
  const std::uint64_t chance =
      unsteadiness_ == Unsteadiness::kEachRead ? ++reads_ : sector * words_ + word;
  const std::uint32_t coin = coins(chance_ ^ (chance * 0xD6E8'FEB8'6659'FD93));
  return (read.bits & ~read.unsteady) | (coin & read.unsteady);
}

bool FlashModel::accept(const FlashOperation& operation) {
  if (left_ == 0) return false;
  --left_;
  ++operations_;
  if (watcher_) watcher_(*this, operation);
  return true;
}

bool FlashModel::program(std::size_t sector, std::size_t word, std::uint32_t value) {
  Word& programmed = at(sector, word);
  if (!accept({FlashOperation::Kind::kProgram, sector, word, value})) return false;
  programmed.bits &= value;
  programmed.unsteady &= value;
  return read(sector, word) == value;
}

bool FlashModel::erase(std::size_t sector) {
  static_cast<void>(at(sector, 0));
  if (!accept({FlashOperation::Kind::kErase, sector})) return false;
  for (std::size_t word = 0; word < words_; ++word) at(sector, word) = {};
  ++erases_[sector];
  return true;
}

void FlashModel::cut_at(const FlashOperation& operation, CutKind kind, std::uint64_t seed) {
  watcher_ = nullptr;
  const bool erases = operation.kind == FlashOperation::Kind::kErase;
  if (erases && kind != CutKind::kBefore) ++erases_[operation.sector];
  if (kind == CutKind::kBefore) return;
  std::mt19937_64 random{seed};
  const auto mood = static_cast<unsigned>(random() % kMoods);
  const std::size_t first = erases ? 0 : operation.word;
  const std::size_t end = erases ? words_ : first + 1;
  const std::uint32_t target = erases ? kErased : operation.value;
  for (std::size_t place = first; place < end; ++place) {
    Word& word = at(operation.sector, place);
    const std::uint32_t to_change =
        erases ? ~word.bits | word.unsteady : (word.bits | word.unsteady) & ~target;
    Tear torn = tear(random, kind, mood);
    if (kind == CutKind::kAfter) torn = {.changed = ~0U, .unsteady = 0};
    const std::uint32_t changed = to_change & torn.changed & ~torn.unsteady;
    word.bits = (word.bits & ~changed) | (target & changed);
    word.unsteady = (word.unsteady & ~changed) | (to_change & torn.unsteady);
  }
}

void FlashModel::power_up(std::uint64_t seed, Unsteadiness unsteadiness) {
  chance_ = seed;
  unsteadiness_ = unsteadiness;
  reads_ = 0;
}

void FlashModel::set_word(std::size_t sector, std::size_t word, std::uint32_t value) {
  at(sector, word) = {.bits = value};
}

}  // namespace hal::host
