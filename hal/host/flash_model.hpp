#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "hal/interface/flash_sectors.hpp"

namespace hal::host {

/// One operation that changes the flash.
struct FlashOperation {
  enum class Kind : std::uint8_t { kProgram, kErase };
  Kind kind = Kind::kProgram;
  std::size_t sector = 0;
  std::size_t word = 0;        ///< Index of the word to program; unused for kErase.
  std::uint32_t value = 0xFF;  ///< Value to program; unused for kErase.
};

/// State in which a power cut leaves the word or sector of the interrupted operation.
enum class CutKind : std::uint8_t {
  kBefore,   ///< Unchanged.
  kAfter,    ///< Changed completely, but the caller gets no result.
  kTorn,     ///< Some bits changed, and the others are unchanged; all are firm.
  kMarginal  ///< Some bits changed, some are unchanged, and some are unsteady.
};

/// Event at which an unsteady bit takes a new random value: each read, or each power-up.
enum class Unsteadiness : std::uint8_t { kEachRead, kEachPowerUp };

/// Model of NOR flash. Programming clears bits; erasing a sector sets all of its bits. The model
/// stores the changes that a power cut left incomplete, and the number of erases of each sector. A
/// copy is an independent flash with the same content.
///
/// An unsteady bit becomes firm when it is programmed to 0 or erased. Unlike on a real chip, a cut
/// does not end the running program: the test that simulates the cut continues with a copy.
class FlashModel final : public FlashSectors {
 public:
  /// Two sectors of 16 KiB, the size of a controller's smallest sectors.
  static constexpr std::size_t kSectors = 2;
  static constexpr std::size_t kWords = 4096;

  explicit FlashModel(std::size_t sectors = kSectors, std::size_t words = kWords);

  [[nodiscard]] std::size_t sector_count() const override { return sectors_; }
  [[nodiscard]] std::size_t words_per_sector() const override { return words_; }
  [[nodiscard]] std::uint32_t read(std::size_t sector, std::size_t word) const override;
  [[nodiscard]] bool program(std::size_t sector, std::size_t word, std::uint32_t value) override;
  [[nodiscard]] bool erase(std::size_t sector) override;

  using Watcher = std::function<void(const FlashModel& before, const FlashOperation& next)>;
  /// Calls `watcher` just before each operation. A null `watcher` ends the calls.
  void watch(Watcher watcher) { watcher_ = std::move(watcher); }
  /// Makes the flash refuse every operation after the next `operations`, as worn or locked flash
  /// does.
  void refuse_after(std::uint64_t operations) { left_ = operations; }
  /// Cuts the power during `operation` and leaves a random state that `seed` determines. The
  /// watcher is not called afterwards.
  void cut_at(const FlashOperation& operation, CutKind kind, std::uint64_t seed);
  /// Simulates a power-up: from now on `seed` determines the values of unsteady bits.
  void power_up(std::uint64_t seed, Unsteadiness unsteadiness);

  [[nodiscard]] std::uint64_t operations() const { return operations_; }
  [[nodiscard]] std::uint32_t erases(std::size_t sector) const { return erases_[sector]; }
  /// Sets a word like a debug probe: any bits may change, and the change does not count as an
  /// operation.
  void set_word(std::size_t sector, std::size_t word, std::uint32_t value);

 private:
  /// Content of a word. Bits that are 1 in `unsteady` may read as 0 or 1.
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
