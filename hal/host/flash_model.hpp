#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "hal/interface/flash_sectors.hpp"

namespace hal::host {

/// One thing asked of flash that changes it.
struct FlashOperation {
  enum class Kind : std::uint8_t { kProgram, kErase };
  Kind kind = Kind::kProgram;
  std::size_t sector = 0;
  std::size_t word = 0;        ///< Of kProgram.
  std::uint32_t value = 0xFF;  ///< Of kProgram.
};

/// How a power cut leaves what was being changed.
enum class CutKind : std::uint8_t {
  kBefore,   ///< As it was.
  kAfter,    ///< As it should be; only nobody heard of it.
  kTorn,     ///< Some bits changed, some unchanged, for good.
  kMarginal  ///< Some bits changed, some unchanged, some that read as either.
};

/// When a bit that is neither 0 nor 1 makes up its mind.
enum class Unsteadiness : std::uint8_t { kEachRead, kEachPowerUp };

/// NOR flash: programming clears bits, erasing a sector sets them all; it remembers what a power
/// cut left half done, and how often it was erased. A copy is the same flash in another future.
///
/// Bits that read unsteadily become firm when they are programmed to 0, or erased. Unlike a chip
/// it ends nobody's run at a cut: whoever plays the cut goes on with a copy.
class FlashModel final : public FlashSectors {
 public:
  /// Two sectors of 16 KiB, as a controller's smallest are.
  static constexpr std::size_t kSectors = 2;
  static constexpr std::size_t kWords = 4096;

  explicit FlashModel(std::size_t sectors = kSectors, std::size_t words = kWords);

  [[nodiscard]] std::size_t sector_count() const override { return sectors_; }
  [[nodiscard]] std::size_t words_per_sector() const override { return words_; }
  [[nodiscard]] std::uint32_t read(std::size_t sector, std::size_t word) const override;
  [[nodiscard]] bool program(std::size_t sector, std::size_t word, std::uint32_t value) override;
  [[nodiscard]] bool erase(std::size_t sector) override;

  using Watcher = std::function<void(const FlashModel& before, const FlashOperation& next)>;
  /// Shows each operation just before it is done; null for nobody.
  void watch(Watcher watcher) { watcher_ = std::move(watcher); }
  /// From the n-th operation from now on flash refuses all, as worn or locked flash does.
  void refuse_after(std::uint64_t operations) { left_ = operations; }
  /// Cuts the power at an operation, at random by the seed. Nobody watches afterwards.
  void cut_at(const FlashOperation& operation, CutKind kind, std::uint64_t seed);
  /// Unsteady bits read by other chances from now on.
  void power_up(std::uint64_t seed, Unsteadiness unsteadiness);

  [[nodiscard]] std::uint64_t operations() const { return operations_; }
  [[nodiscard]] std::uint32_t erases(std::size_t sector) const { return erases_[sector]; }
  /// What a programmer's probe would write: any bits, no operation.
  void set_word(std::size_t sector, std::size_t word, std::uint32_t value);

 private:
  /// What a word holds: bits that are 1 in `unsteady` read as either.
  struct Word {
    std::uint32_t bits = kErased;
    std::uint32_t unsteady = 0;
  };
  [[nodiscard]] const Word& at(std::size_t sector, std::size_t word) const;
  [[nodiscard]] Word& at(std::size_t sector, std::size_t word);
  [[nodiscard]] bool accept(const FlashOperation& operation);

  std::size_t sectors_;
  std::size_t words_;
  std::vector<Word> memory_;
  std::vector<std::uint32_t> erases_;
  Watcher watcher_;
  std::uint64_t operations_ = 0;
  std::uint64_t left_ = ~std::uint64_t{0};
  std::uint64_t chance_ = 0;
  Unsteadiness unsteadiness_ = Unsteadiness::kEachRead;
  mutable std::uint64_t reads_ = 0;
};

}  // namespace hal::host
