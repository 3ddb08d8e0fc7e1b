#include "tests/target/machine/memories.hpp"

#include <fmt/core.h>

#include <array>
#include <cstdio>
#include <cstring>
#include <vector>

#include "tests/target/machine/random.hpp"

namespace machine {

Memories::Memories(qemu::MemoryRegion* container, std::uint64_t seed) {
  constexpr std::uint64_t kCoupled = 0x1000'0000, kCoupledSize = 0x1'0000;
  qemu::memory_region_init_ram(&coupled_, nullptr, "machine-ccm", kCoupledSize, nullptr);
  qemu::memory_region_add_subregion_overlap(container, kCoupled, &coupled_, kOverlayPriority);

  // From the one-time-programmable bytes, which nobody has programmed, to the end of its page.
  constexpr std::uint64_t kIdentity = 0x1FFF'7800, kIdentitySize = 0x400;
  constexpr std::size_t kUnique = 0x210, kFlashSize = 0x222;
  qemu::memory_region_init_rom(&identity_, nullptr, "machine-id", kIdentitySize, nullptr);
  qemu::memory_region_add_subregion_overlap(container, kIdentity, &identity_, kOverlayPriority);
  auto* const bytes = static_cast<std::uint8_t*>(qemu::memory_region_get_ram_ptr(&identity_));
  std::memset(bytes, 0xFF, kIdentitySize);
  Random random{seed};
  const std::array<std::uint64_t, 2> unique = {random.next(), random.next()};
  std::memcpy(bytes + kUnique, unique.data(), 12);
  constexpr std::uint16_t kFlash_kb = 1024;
  std::memcpy(bytes + kFlashSize, &kFlash_kb, sizeof kFlash_kb);
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
