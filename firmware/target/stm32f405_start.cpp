#include "firmware/target/stm32f405_start.hpp"

#include <cstdint>
#include <string_view>

#include "firmware/target/refusal.hpp"
#include "firmware/target/stm32f405_controller.hpp"
#include "firmware/target/stm32f405_ends.hpp"
#include "hal/stm32f405/image.hpp"
#include "planner/base/crc32.hpp"

namespace chip = hal::stm32f405;

namespace target {

void begin_memory() {
  const auto* const own_frame = static_cast<std::uint32_t*>(__builtin_frame_address(0));
  constexpr std::ptrdiff_t kOwnWords = 32;
  for (std::uint32_t* word = stack_bottom; word < own_frame - kOwnWords; ++word) {
    *word = chip::kPaint;
  }
  const std::uint32_t* from = data_load;
  for (std::uint32_t* to = data_begin; to < data_end;) *to++ = *from++;
  for (std::uint32_t* to = bss_begin; to < bss_end;) *to++ = 0;
  for (std::uint32_t* to = ccm_begin; to < ccm_end;) *to++ = 0;
}

std::array<std::span<const std::byte>, 2> checked_parts() {
  const std::size_t at = address_of(&image_header.checksum) - address_of(image_begin);
  const std::span image{image_begin, image_end};
  return {image.first(at), image.subspan(at + sizeof image_header.checksum)};
}

bool image_is_whole() {
  cnc::Crc32 sum;
  for (const std::span<const std::byte> part : checked_parts()) sum.add(part);
  return image_header.magic == chip::ImageHeader::kMagic &&
         image_header.bytes == static_cast<std::uint32_t>(image_end - image_begin) &&
         image_header.checksum == sum.value();
}

namespace {

/// Ends a refusal and restarts into the boot loader, after the serial line has sent its last two
/// bytes.
[[noreturn]] void leave_refusal() {
  constexpr std::uint32_t kLooks = 200'000;
  for (std::uint32_t look = 0; look < kLooks; ++look) asm volatile("nop");
  kept.wanted = Kept::kBootLoader;
  restart();
}

}  // namespace

void refuse(const chip::Clocks& clocks, const chip::Fitness& fitness) {
  kept.fault.mark = 0;
  port.set_up_at_rest();
  line.set_up(clocks);
  usb_line.set_up(clocks);
  constexpr std::size_t kLongestReason = 160;
  std::array<char, kLongestReason> reason{};
  const std::string_view why{reason.data(), chip::describe(fitness, reason)};
  RefusalTalk serial{line, why};
  RefusalTalk usb{usb_line, why};
  serial.greet();
  std::uint32_t session = 0;
  bool leaves = false;
  for (std::uint32_t turn = 0;; ++turn) {
    asm volatile("cpsid i" ::: "memory");
    line.note_turn(turn);
    usb_line.note_turn(turn);
    asm volatile("cpsie i" ::: "memory");
    line.begin_turn(turn);
    usb_line.begin_turn(turn);
    if (const std::uint32_t now = usb_line.session(); now != session) {
      session = now;
      usb.greet();
    }
    leaves = serial.attend() || leaves;
    leaves = usb.attend() || leaves;
    const bool said = serial.idle() && line.sent() && (session == 0 || usb.idle());
    if (leaves && said && usb_line.sent()) leave_refusal();
  }
}

}  // namespace target
