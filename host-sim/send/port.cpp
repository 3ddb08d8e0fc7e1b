#include "host-sim/send/port.hpp"

#include <fmt/format.h>
#include <netdb.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <sys/socket.h>

#include <algorithm>
#include <cerrno>
#include <stdexcept>
#include <utility>

#include "hal/host/descriptor.hpp"
#include "host-sim/send/serial_device.hpp"

namespace sim {

using hal::host::Descriptor;

namespace {

/// Greatest number of bytes that may wait in the kernel. At 115,200 baud, they take 5 ms.
constexpr int kMaxQueued = 64;

bool is_only_slow() { return errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR; }

class DescriptorPort final : public Port {
 public:
  /// @param paced whether the device is slow, and the kernel reports how many bytes wait
  DescriptorPort(Descriptor descriptor, bool paced)
      : descriptor_{std::move(descriptor)}, paced_{paced} {}

  std::size_t read(std::span<char> into) override {
    const ssize_t count = ::read(number(), into.data(), into.size());
    if (count > 0) return static_cast<std::size_t>(count);
    if (count == 0 ? !paced_ : !is_only_slow()) open_ = false;
    if (paced_ && count == 0) look_for_hang_up();
    return 0;
  }

  std::size_t write(std::string_view bytes) override {
    if (paced_) bytes = bytes.substr(0, room());
    if (bytes.empty()) return 0;
    const ssize_t count = ::write(number(), bytes.data(), bytes.size());
    if (count >= 0) return static_cast<std::size_t>(count);
    if (!is_only_slow()) open_ = false;
    return 0;
  }

  bool open() const override { return open_; }
  void add_to(std::vector<pollfd>& descriptors) const override {
    descriptors.push_back({number(), POLLIN, 0});
  }

 private:
  [[nodiscard]] int number() const { return descriptor_.number(); }
  [[nodiscard]] std::size_t room() const {
    int queued = 0;
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-vararg): that is how ioctl is declared.
    if (::ioctl(number(), TIOCOUTQ, &queued) < 0) return kMaxQueued;
    return static_cast<std::size_t>(std::max(0, kMaxQueued - queued));
  }
  /// Checks for a hang-up with poll(), because read() gives the same result for a serial port
  /// without data and for a disconnected port.
  void look_for_hang_up() {
    pollfd state{number(), POLLIN, 0};
    if (::poll(&state, 1, 0) > 0 && (state.revents & (POLLHUP | POLLERR | POLLNVAL)) != 0) {
      open_ = false;
    }
  }

  Descriptor descriptor_;
  bool paced_;
  bool open_ = true;
};

using Addresses = std::unique_ptr<addrinfo, decltype(&::freeaddrinfo)>;

Addresses resolved(const std::string& address) {
  const std::size_t colon = address.rfind(':');
  if (colon == std::string::npos || colon == 0 || colon + 1 == address.size()) {
    throw std::invalid_argument(fmt::format("--tcp {}: must be HOST:PORT", address));
  }
  addrinfo hints{};
  hints.ai_socktype = SOCK_STREAM;
  addrinfo* found = nullptr;
  const int fault = ::getaddrinfo(
      address.substr(0, colon).c_str(), address.substr(colon + 1).c_str(), &hints, &found);
  if (fault != 0) {
    throw std::invalid_argument(fmt::format("--tcp {}: {}", address, ::gai_strerror(fault)));
  }
  return {found, &::freeaddrinfo};
}

/// Returns 0 if the connection is made, otherwise the error number of the reason.
int connect_within(int socket, const addrinfo& place, int milliseconds) {
  if (::connect(socket, place.ai_addr, place.ai_addrlen) == 0) return 0;
  if (errno != EINPROGRESS) return errno;
  pollfd state{socket, POLLOUT, 0};
  if (::poll(&state, 1, milliseconds) <= 0) return ETIMEDOUT;
  int fault = 0;
  socklen_t size = sizeof fault;
  ::getsockopt(socket, SOL_SOCKET, SO_ERROR, &fault, &size);
  return fault;
}

}  // namespace

std::unique_ptr<Port> open_serial_port(const std::string& device, unsigned baud) {
  return std::make_unique<DescriptorPort>(open_serial_device(device, baud), true);
}

std::unique_ptr<Port> open_tcp_port(const std::string& address) {
  constexpr int kPatienceMs = 5000;
  const Addresses places = resolved(address);
  int fault = ECONNREFUSED;
  for (const addrinfo* place = places.get(); place != nullptr; place = place->ai_next) {
    Descriptor socket{::socket(place->ai_family, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0)};
    fault = socket.number() < 0 ? errno : connect_within(socket.number(), *place, kPatienceMs);
    if (fault != 0) continue;
    const int on = 1;
    ::setsockopt(socket.number(), IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
    return std::make_unique<DescriptorPort>(std::move(socket), false);
  }
  throw std::system_error(fault, std::generic_category(), "tcp " + address);
}

}  // namespace sim
