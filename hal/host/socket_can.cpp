#include "hal/host/socket_can.hpp"

#include <linux/can.h>
#include <linux/can/error.h>
#include <linux/can/raw.h>
#include <net/if.h>
#include <net/if_arp.h>
#include <sys/ioctl.h>
#include <sys/socket.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <system_error>
#include <vector>

namespace hal::host {
namespace {

using KernelFrame = struct ::can_frame;

constexpr std::uint32_t kLimit11 = 0x7FF;

[[noreturn]] void refuse(const std::string& interface, const std::string& why) {
  throw std::runtime_error("can " + interface + ": " + why);
}

[[noreturn]] void refuse(const std::string& interface, int fault) {
  refuse(interface, std::generic_category().message(fault));
}

Descriptor open_socket(const std::string& interface) {
  Descriptor socket{::socket(PF_CAN, SOCK_RAW | SOCK_NONBLOCK | SOCK_CLOEXEC, CAN_RAW)};
  if (socket.number() >= 0) return socket;
  switch (errno) {
    case EAFNOSUPPORT:
      refuse(interface, "this kernel has no CAN: modprobe can");
    case EPROTONOSUPPORT:
    case ESOCKTNOSUPPORT:
      refuse(interface, "this kernel has no raw CAN: modprobe can-raw");
    case EPERM:
    case EACCES:
      refuse(interface, "no permission to use CAN");
    default:
      refuse(interface, errno);
  }
}

/// Returns an ioctl request for the interface.
ifreq request_for(const std::string& interface) {
  ifreq request{};
  if (interface.empty() || interface.size() >= sizeof request.ifr_name) {
    refuse(interface, "no interface has such a name");
  }
  std::copy(interface.begin(), interface.end(), std::begin(request.ifr_name));
  return request;
}

/// Returns the number of the interface. Throws if the interface is not a CAN bus or is down, so
/// that the user learns this before a program waits for frames.
int find_interface(const Descriptor& socket, const std::string& interface) {
  ifreq request = request_for(interface);
  const auto ask = [&](unsigned long question) {
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-vararg): that is how ioctl is declared.
    if (::ioctl(socket.number(), question, &request) == 0) return;
    if (errno == ENODEV) {
      refuse(interface, "there is no such interface: ip link add dev vcan0 type vcan makes one");
    }
    refuse(interface, errno);
  };
  ask(SIOCGIFHWADDR);
  if (request.ifr_hwaddr.sa_family != ARPHRD_CAN) refuse(interface, "is no CAN bus");
  ask(SIOCGIFFLAGS);
  if ((request.ifr_flags & IFF_UP) == 0) {
    refuse(interface, "is down: ip link set " + interface + " up");
  }
  ask(SIOCGIFINDEX);
  return request.ifr_ifindex;
}

void bind_to(const Descriptor& socket, const std::string& interface) {
  sockaddr_can address{};
  address.can_family = AF_CAN;
  address.can_ifindex = find_interface(socket, interface);
  const auto* const any = reinterpret_cast<const sockaddr*>(&address);
  if (::bind(socket.number(), any, sizeof address) == 0) return;
  if (errno == EPERM || errno == EACCES) refuse(interface, "no permission to use it");
  refuse(interface, errno);
}

template <typename Value>
void set_option(int socket, int level, int option, const Value& value) {
  checked(::setsockopt(socket, level, option, &value, sizeof value), "can");
}

KernelFrame to_kernel(const CanFrame& frame) {
  KernelFrame raw{};
  raw.can_id = frame.id | (frame.extended ? CAN_EFF_FLAG : 0U) | (frame.remote ? CAN_RTR_FLAG : 0U);
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-union-access): one byte with two names.
  raw.can_dlc = frame.length;
  if (!frame.remote) std::memcpy(raw.data, frame.data.data(), frame.length);
  return raw;
}

CanFrame from_kernel(const KernelFrame& raw) {
  CanFrame frame;
  frame.extended = (raw.can_id & CAN_EFF_FLAG) != 0;
  frame.remote = (raw.can_id & CAN_RTR_FLAG) != 0;
  frame.id = raw.can_id & (frame.extended ? CAN_EFF_MASK : CAN_SFF_MASK);
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-union-access): one byte with two names.
  frame.length = std::min<std::uint8_t>(raw.can_dlc, CAN_MAX_DLEN);
  if (!frame.remote) std::memcpy(frame.data.data(), raw.data, frame.length);
  return frame;
}

/// Returns the kernel's count of dropped frames, or `known` if the message contains no count.
std::uint32_t drops_in(msghdr& message, std::uint32_t known) {
  for (cmsghdr* part = CMSG_FIRSTHDR(&message); part != nullptr;
       part = CMSG_NXTHDR(&message, part)) {
    if (part->cmsg_level != SOL_SOCKET || part->cmsg_type != SO_RXQ_OVFL) continue;
    std::memcpy(&known, CMSG_DATA(part), sizeof known);
  }
  return known;
}

bool is_only_full(int fault) { return fault == EAGAIN || fault == EINTR || fault == ENOBUFS; }

}  // namespace

SocketCan::SocketCan(const std::string& interface, std::span<const std::uint32_t> heard)
    : socket_{open_socket(interface)} {
  SocketCan::hear_only(heard, 0);
  bind_to(socket_, interface);
}

void SocketCan::hear_only(std::span<const std::uint32_t> heard, std::size_t /*urgent*/) {
  constexpr can_err_mask_t kErrors = CAN_ERR_CRTL | CAN_ERR_BUSOFF | CAN_ERR_RESTARTED;
  std::vector<can_filter> filters;
  for (const std::uint32_t id : heard) {
    // The mask must not contain the error flag, because the kernel would then apply the filter to
    // error frames and not to data frames.
    filters.push_back(
        {.can_id = id & kLimit11, .can_mask = CAN_SFF_MASK | CAN_EFF_FLAG | CAN_RTR_FLAG});
  }
  const auto size = static_cast<socklen_t>(filters.size() * sizeof(can_filter));
  checked(::setsockopt(number(), SOL_CAN_RAW, CAN_RAW_FILTER, filters.data(), size), "can");
  set_option(number(), SOL_CAN_RAW, CAN_RAW_ERR_FILTER, kErrors);
  set_option(number(), SOL_SOCKET, SO_RXQ_OVFL, 1);
}

bool SocketCan::receive(CanFrame& frame) {
  // Greatest number of error frames in one call, which bounds its time. Further error frames wait
  // for the next call.
  constexpr int kMaxErrors = 64;
  for (int errors = 0; errors < kMaxErrors; ++errors) {
    KernelFrame raw{};
    iovec place{&raw, sizeof raw};
    alignas(cmsghdr) std::array<char, CMSG_SPACE(sizeof(std::uint32_t))> control{};
    msghdr message{};
    message.msg_iov = &place;
    message.msg_iovlen = 1;
    message.msg_control = control.data();
    message.msg_controllen = control.size();
    const ssize_t count = ::recvmsg(number(), &message, 0);
    if (count < 0) {
      take_fault(errno);
      return false;
    }
    count_drops(drops_in(message, drops_));
    if (count != sizeof raw) continue;
    if ((raw.can_id & CAN_ERR_FLAG) == 0) {
      frame = from_kernel(raw);
      return true;
    }
    take_error(raw.can_id, raw.data);
  }
  return false;
}

bool SocketCan::send(const CanFrame& frame) {
  if (frame.length > frame.data.size() || room() == 0) return false;
  to_send_.push_back(frame);
  flush();
  return true;
}

void SocketCan::flush() {
  while (!to_send_.empty()) {
    const KernelFrame raw = to_kernel(to_send_.front());
    if (::write(number(), &raw, sizeof raw) < 0) return take_fault(errno);
    to_send_.pop_front();
    up_ = true;
  }
}

/// Handles a failed call: the interface is down or unplugged, or it has no free space at present.
void SocketCan::take_fault(int fault) {
  if (is_only_full(fault)) return;
  to_send_.clear();
  if (up_) ++health_.lost_frames;
  up_ = false;
}

void SocketCan::take_error(std::uint32_t kinds, std::span<const std::uint8_t> details) {
  constexpr unsigned kWarned = CAN_ERR_CRTL_RX_WARNING | CAN_ERR_CRTL_TX_WARNING;
  constexpr unsigned kTurnedPassive = CAN_ERR_CRTL_RX_PASSIVE | CAN_ERR_CRTL_TX_PASSIVE;
  if ((kinds & CAN_ERR_CRTL) != 0) {
    const unsigned what = details[1];
    if ((what & CAN_ERR_CRTL_RX_OVERFLOW) != 0) ++health_.lost_frames;
    if ((what & CAN_ERR_CRTL_ACTIVE) != 0) health_.state = CanState::kActive;
    if ((what & kWarned) != 0) health_.state = CanState::kWarning;
    if ((what & kTurnedPassive) != 0) health_.state = CanState::kPassive;
    health_.transmit_errors = details[6];
    health_.receive_errors = details[7];
  }
  if ((kinds & CAN_ERR_BUSOFF) != 0) {
    health_.state = CanState::kBusOff;
    ++health_.bus_offs;
  }
  if ((kinds & CAN_ERR_RESTARTED) != 0) health_.state = CanState::kActive;
}

void SocketCan::count_drops(std::uint32_t drops) {
  health_.lost_frames += drops - drops_;
  drops_ = drops;
}

}  // namespace hal::host
