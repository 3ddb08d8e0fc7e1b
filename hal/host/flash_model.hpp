#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "hal/interface/flash_sectors.hpp"

namespace hal::host {

/// One operation that changes flash.
struct FlashOperation {
  enum class Kind : std::uint8_t { kProgram, kErase };
  Kind kind = Kind::kProgram;
  std::size_t sector = 0;
  std::size_t word = 0;        ///< Word to program; unused by kErase.
  std::uint32_t value = 0xFF;  ///< Value to program; unused by kErase.
};

/// State in which a power cut leaves the word or sector that was being changed.
enum class CutKind : std::uint8_t {
  kBefore,   ///< Unchanged.
  kAfter,    ///< Changed completely, although the caller never learns that.
  kTorn,     ///< Some bits changed and some unchanged; all are firm.
  kMarginal  ///< Some bits changed, some unchanged, and some unsteady.
};

/// Time at which an unsteady bit is decided again: each read, or each power-up.
enum class Unsteadiness : std::uint8_t { kEachRead, kEachPowerUp };

/// Model of NOR flash. Programming clears bits, and erasing a sector sets all of its bits. The
/// model remembers which changes a power cut left half done, and how often each sector was erased.
/// A copy is an independent flash with the same content.
///
/// Unsteady bits become firm when they are programmed to 0, or erased. Unlike on a real chip, a cut
/// does not end the running program: the test that simulates the cut continues with a copy.
class FlashModel final : public FlashSectors {
 public:
  /// Two sectors of 16 KiB, the smallest sectors of a controller.
  static constexpr std::size_t kSectors = 2;
  static constexpr std::size_t kWords = 4096;

  explicit FlashModel(std::size_t sectors = kSectors, std::size_t words = kWords);

  [[nodiscard]] std::size_t sector_count() const override { return sectors_; }
  [[nodiscard]] std::size_t words_per_sector() const override { return words_; }
  [[nodiscard]] std::uint32_t read(std::size_t sector, std::size_t word) const override;
  [[nodiscard]] bool program(std::size_t sector, std::size_t word, std::uint32_t value) override;
  [[nodiscard]] bool erase(std::size_t sector) override;

  using Watcher = std::function<void(const FlashModel& before, const FlashOperation& next)>;
  /// Calls `watcher` just before each operation; a null watcher ends that.
  void watch(Watcher watcher) { watcher_ = std::move(watcher); }
  /// Makes the flash refuse every operation after the next `operations`, as worn or locked flash
  /// does.
  void refuse_after(std::uint64_t operations) { left_ = operations; }
  /// Cuts the power during an operation, at a random state given by the seed. The watcher is not
  /// called afterwards.
  void cut_at(const FlashOperation& operation, CutKind kind, std::uint64_t seed);
  /// Simulates a power-up: from now on unsteady bits read by the chances of `seed`.
  void power_up(std::uint64_t seed, Unsteadiness unsteadiness);

  [[nodiscard]] std::uint64_t operations() const { return operations_; }
  [[nodiscard]] std::uint32_t erases(std::size_t sector) const { return erases_[sector]; }
  /// Writes a word as a programmer's probe would: any bits may change, and no operation counts.
  void set_word(std::size_t sector, std::size_t word, std::uint32_t value);

 private:
  /// Content of a word. Bits that are 1 in `unsteady` may read as either value.
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
