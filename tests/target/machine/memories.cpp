#include "tests/target/machine/memories.hpp"

#include <fmt/core.h>

#include <array>
#include <cstdio>
#include <cstring>
#include <vector>

#include "tests/target/machine/random.hpp"

namespace machine {

Memories::Memories(const Memory& memory, const Options& options) {
  constexpr std::uint64_t kCoupled = 0x1000'0000, kCoupledSize = 0x1'0000;
  qemu::memory_region_init_ram(&coupled_, nullptr, "machine-ccm", kCoupledSize, nullptr);
  qemu::memory_region_add_subregion_overlap(memory.system, kCoupled, &coupled_, kOverlayPriority);
  lay_identity(memory.system, options);

  constexpr std::uint64_t kDeviceCode = 0xE004'2000, kDeviceCodeSize = 0x400;
  qemu::memory_region_init_rom(&device_code_, nullptr, "machine-code", kDeviceCodeSize, nullptr);
  qemu::memory_region_add_subregion_overlap(
      memory.core, kDeviceCode, &device_code_, kOverlayPriority);
  constexpr std::uint32_t kF405 = 0x1007'6413;
  std::memcpy(qemu::memory_region_get_ram_ptr(&device_code_), &kF405, sizeof kF405);
}

void Memories::lay_identity(qemu::MemoryRegion* container, const Options& options) {
  // Range from the one-time-programmable bytes, which are not programmed, to the end of their page.
  constexpr std::uint64_t kIdentity = 0x1FFF'7800, kIdentitySize = 0x400;
  constexpr std::size_t kUnique = 0x210, kFlashSize = 0x222;
  qemu::memory_region_init_rom(&identity_, nullptr, "machine-id", kIdentitySize, nullptr);
  qemu::memory_region_add_subregion_overlap(container, kIdentity, &identity_, kOverlayPriority);
  auto* const bytes = static_cast<std::uint8_t*>(qemu::memory_region_get_ram_ptr(&identity_));
  std::memset(bytes, 0xFF, kIdentitySize);
  Random random{options.seed};
  const std::array<std::uint64_t, 2> unique = {random.next(), random.next()};
  std::memcpy(bytes + kUnique, unique.data(), 12);
  const auto kib = static_cast<std::uint16_t>(options.flash_kib);
  std::memcpy(bytes + kFlashSize, &kib, sizeof kib);
}

void Memories::save(const std::string& file) {
  constexpr std::uint32_t kBegin = 0x2000'0000, kSize = 0x2'0000;
  if (file.empty()) return;
  std::vector<std::uint8_t> bytes(kSize);
  qemu::cpu_physical_memory_rw(kBegin, bytes.data(), kSize, false);
  std::FILE* const out = std::fopen(file.c_str(), "wb");
  const bool good = out != nullptr && std::fwrite(bytes.data(), 1, kSize, out) == kSize;
  if (out == nullptr || std::fclose(out) != 0 || !good) {
    fmt::print(stderr, "machine: cannot write {}\n", file);
  }
}

}  // namespace machine
