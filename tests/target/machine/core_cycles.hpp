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

/// Model of the core at 168 MHz that counts instructions and cycles, by its pipeline and the flash.
/// The counts are words from the address of the cycle counter's control (DWT) on, of which the chip
/// has only two. They count while the first word is 1; code that runs while it is 0 leaves no trace
/// in the caches.
///
/// Not modelled: entry to exceptions, busy buses, and the length of integer divisions.
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
  /// Lays the words over the emulator's registers.
  void map(qemu::MemoryRegion* core);

 private:
  struct Known {
    CoreCycles* owner;
    InstructionCost cost;
  };

  /// Computes the costs of an instruction. @return the record that holds them
  Known* know(const qemu::Instruction* instruction);
  void count(bool on);
  void execute(const InstructionCost& cost);
  void load(std::uint64_t address);
  [[nodiscard]] std::uint64_t word(std::uint64_t which) const;

  std::unordered_map<std::uint32_t, std::unique_ptr<Known>> known_;
  FlashAccelerator flash_;
  std::optional<InstructionCost> last_;
  bool counts_ = false;
  std::array<std::uint64_t, kWords> words_{};  ///< The counts, except those that `flash_` keeps.
  qemu::MemoryRegion region_{};
};

}  // namespace machine
