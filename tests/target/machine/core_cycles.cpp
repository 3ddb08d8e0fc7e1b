#include "tests/target/machine/core_cycles.hpp"

#include <algorithm>
#include <span>

#include "tests/target/machine/peripheral.hpp"

namespace machine {
namespace {

/// Cycles to refill the pipeline after a branch: the middle of the manual's 1 to 3.
constexpr std::uint64_t kRefill = 2;

bool is_flash(std::uint64_t address) { return address - 0x0800'0000 < 0x10'0000; }

/// There is one core, and QEMU passes no object to the function that sees translations.
CoreCycles* the_core = nullptr;

}  // namespace

CoreCycles::CoreCycles(qemu::PluginId id) {
  the_core = this;
  qemu::qemu_plugin_register_vcpu_tb_trans_cb(
      id, [](qemu::PluginId, qemu::TranslationBlock* block) {
        const std::size_t count = qemu::qemu_plugin_tb_n_insns(block);
        for (std::size_t i = 0; i < count; ++i) {
          qemu::Instruction* const instruction = qemu::qemu_plugin_tb_get_insn(block, i);
          Known* const known = the_core->know(instruction);
          qemu::qemu_plugin_register_vcpu_insn_exec_cb(
              instruction,
              [](unsigned, void* data) {
                const Known& here = *static_cast<const Known*>(data);
                here.owner->execute(here.cost);
              },
              qemu::kNoRegisters,
              known);
          if (!known->cost.loads) continue;
          qemu::qemu_plugin_register_vcpu_mem_cb(
              instruction,
              [](unsigned, qemu::MemoryInfo, std::uint64_t address, void* data) {
                static_cast<const Known*>(data)->owner->load(address);
              },
              qemu::kNoRegisters,
              qemu::kReads,
              known);
        }
      });
}

void CoreCycles::map(qemu::MemoryRegion* core) {
  static constexpr qemu::MemoryRegionOps kOps{
      .read = [](void* owner,
                 qemu::HardwareAddress offset,
                 unsigned) { return static_cast<const CoreCycles*>(owner)->word(offset / 4); },
      .write =
          [](void* owner, qemu::HardwareAddress offset, std::uint64_t value, unsigned) {
            if (offset == 0) static_cast<CoreCycles*>(owner)->count(value == 1);
          },
      .read_with_attrs = nullptr,
      .write_with_attrs = nullptr,
      .endianness = qemu::kLittleEndian,
      .valid = {.min = 4, .max = 4, .unaligned = false, .accepts = nullptr},
      .impl = {.min = 4, .max = 4, .unaligned = false}};
  constexpr std::uint64_t kAddress = 0xE000'1000, kSize = 4 * kWords;
  qemu::memory_region_init_io(&region_, nullptr, &kOps, this, "machine-cycles", kSize);
  qemu::memory_region_add_subregion_overlap(core, kAddress, &region_, kOverlayPriority);
}

CoreCycles::Known* CoreCycles::know(const qemu::Instruction* instruction) {
  const auto address = static_cast<std::uint32_t>(qemu::qemu_plugin_insn_vaddr(instruction));
  const std::span code{static_cast<const std::uint8_t*>(qemu::qemu_plugin_insn_data(instruction)),
                       qemu::qemu_plugin_insn_size(instruction)};
  std::unique_ptr<Known>& place = known_[address];
  if (place == nullptr) place = std::make_unique<Known>(Known{this, {}});
  place->cost = cost_of(address, code);
  return place.get();
}

void CoreCycles::count(bool on) {
  counts_ = on;
  last_.reset();
}

void CoreCycles::execute(const InstructionCost& cost) {
  if (!counts_) return;
  std::uint64_t& cycles = words_[kCycles];
  const bool taken = last_ && cost.address != last_->end();
  if (taken) cycles += kRefill;
  if (is_flash(cost.address)) {
    cycles += flash_.fetch(cost.address, cycles);
    cycles += flash_.fetch(cost.end() - 1, cycles);
  }
  const bool waits =
      last_ && last_->result != InstructionCost::kNone &&
      std::find(cost.operands.begin(), cost.operands.end(), last_->result) != cost.operands.end();
  const bool overlaps = last_ && last_->moves_one && cost.loads && cost.moves_one;
  cycles += cost.cycles + (waits ? 1U : 0U) - (overlaps ? 1U : 0U);
  ++words_[kInstructions];
  words_[kLoads] += cost.loads ? 1 : 0;
  words_[kTaken] += taken ? 1 : 0;
  words_[kDivisions] += cost.divides ? 1 : 0;
  last_ = cost;
}

void CoreCycles::load(std::uint64_t address) {
  if (!counts_ || !is_flash(address)) return;
  words_[kCycles] += flash_.load(static_cast<std::uint32_t>(address));
}

std::uint64_t CoreCycles::word(std::uint64_t which) const {
  return which == kMisses ? flash_.misses() : words_[which];
}

}  // namespace machine
