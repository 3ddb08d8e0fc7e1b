#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <unordered_map>

#include "tests/target/machine/flash_accelerator.hpp"
#include "tests/target/machine/instruction_cost.hpp"
#include "tests/target/machine/qemu.hpp"

namespace machine {

/// Instructions and cycles of the core at 168 MHz as a model of its pipeline and of the flash
/// gives them, and the counts behind them: words from the address of the cycle counter's control
/// (DWT) on, of which the chip has but two. They count while the first is 1; code that runs
/// meanwhile leaves no trace in the caches. Entry to exceptions, buses that are busy and the length
/// of integer divisions are not modelled.
class CoreCycles {
 public:
  enum Word : std::uint32_t {
    kControl,
    kCycles,
    kInstructions,
    kLoads,
    kTaken,
    kDivisions,
    kMisses,
    kWords
  };

  /// Follows all code that the emulator translates from now on.
  explicit CoreCycles(qemu::PluginId id);
  /// Lays the words over what the emulator has there.
  void map(qemu::MemoryRegion* core);

 private:
  struct Known {
    CoreCycles* owner;
    InstructionCost cost;
  };

  /// @return where the costs of this instruction stay
  Known* know(const qemu::Instruction* instruction);
  void count(bool on);
  void execute(const InstructionCost& cost);
  void load(std::uint64_t address);
  [[nodiscard]] std::uint64_t word(std::uint64_t which) const;

  std::unordered_map<std::uint32_t, std::unique_ptr<Known>> known_;
  FlashAccelerator flash_;
  std::optional<InstructionCost> last_;
  bool counts_ = false;
  std::array<std::uint64_t, kWords> words_{};  ///< Those of the flash are its own.
  qemu::MemoryRegion region_{};
};

}  // namespace machine
