#pragma once

// Functions of QEMU 7.2 that this plug-in calls, declared here because no package contains these
// headers. Names, layouts and numbers are those of that release: include/exec/memory.h,
// include/qemu/timer.h, include/qemu/notify.h, include/qemu/qemu-plugin.h,
// include/chardev/char-fe.h.

#include <cstddef>
#include <cstdint>

namespace qemu {

extern "C" {

using HardwareAddress = std::uint64_t;

/// These types are larger than QEMU's own, of which QEMU writes only the beginning.
struct MemoryRegion {
  alignas(16) unsigned char content[2048];
};
struct Timer {
  alignas(16) unsigned char content[256];
};
struct CharBackend {
  alignas(16) unsigned char content[256];
};

struct Error;
struct Object;
struct Chardev;
using Irq = struct IRQState*;

struct AccessAttributes {
  std::uint32_t bits;
};

enum AccessResult : std::uint32_t { kAccessOk = 0, kAccessError = 1 };

struct AccessSizes {
  unsigned min;
  unsigned max;
  bool unaligned;
};

struct ValidAccesses {
  unsigned min;
  unsigned max;
  bool unaligned;
  bool (*accepts)(void*, HardwareAddress, unsigned, bool, AccessAttributes);
};

struct MemoryRegionOps {
  std::uint64_t (*read)(void*, HardwareAddress, unsigned);
  void (*write)(void*, HardwareAddress, std::uint64_t, unsigned);
  AccessResult (*read_with_attrs)(
      void*, HardwareAddress, std::uint64_t*, unsigned, AccessAttributes);
  AccessResult (*write_with_attrs)(
      void*, HardwareAddress, std::uint64_t, unsigned, AccessAttributes);
  int endianness;
  ValidAccesses valid;
  AccessSizes impl;
};
constexpr int kLittleEndian = 2;

MemoryRegion* get_system_memory();
void memory_region_init_io(
    MemoryRegion*, Object* owner, const MemoryRegionOps*, void*, const char*, std::uint64_t size);
void memory_region_init_rom_device(MemoryRegion*,
                                   Object* owner,
                                   const MemoryRegionOps*,
                                   void*,
                                   const char*,
                                   std::uint64_t size,
                                   Error**);
void memory_region_init_ram(MemoryRegion*, Object* owner, const char*, std::uint64_t size, Error**);
void memory_region_init_rom(MemoryRegion*, Object* owner, const char*, std::uint64_t size, Error**);
void memory_region_init_alias(MemoryRegion*,
                              Object* owner,
                              const char*,
                              MemoryRegion* of,
                              HardwareAddress offset,
                              std::uint64_t size);
void memory_region_add_subregion_overlap(MemoryRegion* container,
                                         HardwareAddress,
                                         MemoryRegion*,
                                         int priority);
void* memory_region_get_ram_ptr(MemoryRegion*);
void memory_region_flush_rom_device(MemoryRegion*, HardwareAddress, HardwareAddress size);
void cpu_physical_memory_rw(HardwareAddress, void*, HardwareAddress size, bool is_write);

constexpr int kVirtualClock = 1;
std::int64_t qemu_clock_get_ns(int clock);
void timer_init_full(
    Timer*, void* group, int clock, int scale, int attributes, void (*)(void*), void*);
void timer_mod_ns(Timer*, std::int64_t at_ns);
void timer_del(Timer*);

Object* object_resolve_path_type(const char* path, const char* type, bool* ambiguous);
Object* object_resolve_path_component(Object*, const char* part);
Irq qdev_get_gpio_in(Object* device, int number);
void qemu_set_irq(Irq, int level);
Irq qemu_allocate_irq(void (*)(void*, int number, int level), void*, int number);
void qdev_connect_gpio_out_named(Object* device, const char* name, int number, Irq);

constexpr int kGuestReset = 7;
void qemu_system_reset(int cause);
void qemu_register_reset(void (*)(void*), void*);

struct Notifier {
  void (*notify)(Notifier*, void*);
  Notifier* next;
  Notifier** previous;
};
void qemu_add_machine_init_done_notifier(Notifier*);

Chardev* qemu_chr_find(const char* name);
bool qemu_chr_fe_init(CharBackend*, Chardev*, Error**);
void qemu_chr_fe_set_handlers(CharBackend*,
                              int (*can_read)(void*),
                              void (*read)(void*, const std::uint8_t*, int size),
                              void (*event)(void*, int),
                              int (*backend_change)(void*),
                              void* opaque,
                              void* context,
                              bool set_open);
int qemu_chr_fe_write_all(CharBackend*, const std::uint8_t*, int size);
void qemu_chr_fe_accept_input(CharBackend*);

using PluginId = std::uint64_t;
struct PluginInfo {
  const char* target_name;
  struct {
    int min;
    int cur;
  } version;
  bool system_emulation;
};
void qemu_plugin_register_atexit_cb(PluginId, void (*)(PluginId, void*), void*);

struct TranslationBlock;
struct Instruction;
using MemoryInfo = std::uint32_t;
enum RegisterUse : unsigned { kNoRegisters = 0 };
enum Accesses : unsigned { kReads = 1 };
void qemu_plugin_register_vcpu_tb_trans_cb(PluginId, void (*)(PluginId, TranslationBlock*));
std::size_t qemu_plugin_tb_n_insns(const TranslationBlock*);
Instruction* qemu_plugin_tb_get_insn(const TranslationBlock*, std::size_t);
const void* qemu_plugin_insn_data(const Instruction*);
std::size_t qemu_plugin_insn_size(const Instruction*);
std::uint64_t qemu_plugin_insn_vaddr(const Instruction*);
void qemu_plugin_register_vcpu_insn_exec_cb(Instruction*,
                                            void (*)(unsigned core, void*),
                                            RegisterUse,
                                            void*);
void qemu_plugin_register_vcpu_mem_cb(
    Instruction*,
    void (*)(unsigned core, MemoryInfo, std::uint64_t address, void*),
    RegisterUse,
    Accesses,
    void*);
}

}  // namespace qemu
