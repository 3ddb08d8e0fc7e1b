#include "host-sim/serve/slcan_wire.hpp"

#include <array>

namespace sim {

SlcanWire::SlcanWire(const std::string& link) : link_{link} { link_.point_to(master_.device()); }

void SlcanWire::carry() {
  if (!master_.in_use()) {
    if (used_) {
      slcan_.close();
      master_.flush();
    }
    used_ = false;
    return;
  }
  used_ = true;
  std::array<std::byte, 256> heard{};
  while (slcan_.can_hear()) {
    const ssize_t count = ::read(master_.number(), heard.data(), heard.size());
    if (count <= 0) break;
    slcan_.hear(std::span{heard}.first(static_cast<std::size_t>(count)));
  }
  const std::string_view words = slcan_.to_say();
  if (words.empty()) return;
  const ssize_t count = ::write(master_.number(), words.data(), words.size());
  if (count > 0) slcan_.said(static_cast<std::size_t>(count));
}

void SlcanWire::add_to(std::vector<pollfd>& descriptors) const {
  // No event reports that a program opens the port. While no program has opened the port, poll()
  // always reports it as readable. So the port is not polled then.
  if (used_ && slcan_.can_hear()) descriptors.push_back({master_.number(), POLLIN, 0});
}

}  // namespace sim
