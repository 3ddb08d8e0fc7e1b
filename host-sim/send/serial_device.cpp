#include "host-sim/send/serial_device.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <termios.h>

#include <array>
#include <optional>
#include <stdexcept>
#include <utility>

#include "hal/host/system_call.hpp"

namespace sim {

using hal::host::checked;
using hal::host::Descriptor;

namespace {

std::optional<speed_t> speed_of(unsigned baud) {
  constexpr std::array<std::pair<unsigned, speed_t>, 15> kSpeeds{{{9600, B9600},
                                                                  {19200, B19200},
                                                                  {38400, B38400},
                                                                  {57600, B57600},
                                                                  {115200, B115200},
                                                                  {230400, B230400},
                                                                  {460800, B460800},
                                                                  {500000, B500000},
                                                                  {576000, B576000},
                                                                  {921600, B921600},
                                                                  {1000000, B1000000},
                                                                  {1500000, B1500000},
                                                                  {2000000, B2000000},
                                                                  {3000000, B3000000},
                                                                  {4000000, B4000000}}};
  for (const auto& [number, speed] : kSpeeds) {
    if (number == baud) return speed;
  }
  return std::nullopt;
}

}  // namespace

Descriptor open_serial_device(const std::string& device, unsigned baud) {
  const auto speed = speed_of(baud);
  if (!speed)
    throw std::invalid_argument(fmt::format("--baud {}: no serial port has this rate", baud));
  Descriptor port{hal::host::open_file(device, O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC)};
  checked(port.number(), device);
  if (::flock(port.number(), LOCK_EX | LOCK_NB) < 0) {
    throw std::invalid_argument(fmt::format("{}: another program uses it", device));
  }
  termios mode{};
  checked(::tcgetattr(port.number(), &mode), device);
  ::cfmakeraw(&mode);
  mode.c_cflag |= CLOCAL | CREAD;
  mode.c_cc[VMIN] = 0;
  mode.c_cc[VTIME] = 0;
  checked(::cfsetspeed(&mode, *speed), device);
  checked(::tcsetattr(port.number(), TCSAFLUSH, &mode), device);
  return port;
}

}  // namespace sim
