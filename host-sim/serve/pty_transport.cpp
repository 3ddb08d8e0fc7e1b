#include "host-sim/serve/pty_transport.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <termios.h>

#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <stdexcept>

#include "hal/host/system_call.hpp"

namespace sim {
namespace {

using hal::host::checked;
using hal::host::Descriptor;

namespace fs = std::filesystem;

constexpr std::size_t kLongestDeviceName = 64;

/// Makes a terminal raw. Also forgets the bytes that the sender's end has not read yet.
void make_raw(int terminal) {
  termios mode{};
  checked(::tcgetattr(terminal, &mode), "pty");
  ::cfmakeraw(&mode);
  ::cfsetspeed(&mode, B115200);  // Senders read the speed back and expect this value.
  checked(::tcsetattr(terminal, TCSAFLUSH, &mode), "pty");
}

std::string device_of(int master) {
  std::string name(kLongestDeviceName, '\0');
  const int fault = ::ptsname_r(master, name.data(), name.size());
  if (fault != 0) throw std::system_error(fault, std::generic_category(), "pty");
  name.resize(name.find('\0'));
  return name;
}

/// Opens and closes a device. The kernel reports that a terminal is closed only after the terminal
/// was open once.
void open_once(const std::string& device) {
  const Descriptor slave{hal::host::open_file(device, O_RDWR | O_NOCTTY | O_CLOEXEC)};
  checked(slave.number(), device);
}

}  // namespace

PtyMaster::PtyMaster()
    : master_{checked(::posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC), "pty")} {
  checked(::grantpt(number()), "pty");
  make_raw(number());  // Sets raw mode for both ends, which share it.
  checked(::unlockpt(number()), "pty");
  device_ = device_of(number());
  open_once(device_);
}

bool PtyMaster::in_use() const {
  pollfd state{number(), POLLIN, 0};
  if (::poll(&state, 1, 0) < 0) return false;
  return (state.revents & POLLIN) != 0 || (state.revents & POLLHUP) == 0;
}

void PtyMaster::flush() const {
  ::tcflush(number(), TCIOFLUSH);
  make_raw(number());  // Restores raw mode, because the last sender may have changed it.
}

void PtyLink::point_to(const std::string& device) {
  const fs::path link{path_};
  const fs::file_status there = fs::symlink_status(link);
  if (fs::exists(there)) {
    const bool of_a_pty =
        fs::is_symlink(there) && fs::read_symlink(link).string().starts_with("/dev/pts/");
    if (!of_a_pty) {
      throw std::invalid_argument(fmt::format(
          "--pty {}: a file of this name exists and is no link to a pty; choose another name",
          path_));
    }
    // A pty ends with its server. A link that an earlier server left points to no device, or to
    // `device` if this has the number of the old pty.
    const fs::path leads_to = fs::read_symlink(link);
    const bool is_own = leads_to == device || leads_to == device_;
    if (!is_own && fs::exists(leads_to)) {
      throw std::invalid_argument(
          fmt::format("--pty {}: leads to {}, which is in use, perhaps by another server: choose "
                      "another name, or remove the link",
                      path_,
                      leads_to.string()));
    }
  }
  const fs::path fresh{fmt::format("{}.{}", path_, ::getpid())};
  fs::create_symlink(device, fresh);
  fs::rename(fresh, link);
  device_ = device;
}

void PtyLink::remove() const {
  // The link was never made, so a file of this name does not belong to this process.
  if (device_.empty()) return;
  std::error_code ignored;
  if (fs::read_symlink(path_, ignored) == device_) fs::remove(path_, ignored);
}

class PtyTransport::Sender final : public Connection {
 public:
  explicit Sender(PtyTransport& transport) : transport_{transport} {}
  Sender(const Sender&) = delete;
  Sender& operator=(const Sender&) = delete;
  ~Sender() override { transport_.release(); }

  std::size_t read(std::span<std::byte> into) override {
    const ssize_t count = ::read(master().number(), into.data(), into.size());
    // An error such as EIO means that the port is closed, which open() reports.
    return count > 0 ? static_cast<std::size_t>(count) : 0;
  }
  std::size_t write(std::span<const std::byte> from) override {
    const ssize_t count = ::write(master().number(), from.data(), from.size());
    return count > 0 ? static_cast<std::size_t>(count) : 0;
  }
  bool open() override { return master().in_use(); }
  void end() override {}
  void add_to(std::vector<pollfd>& descriptors, Wishes wishes) const override {
    const int events = (wishes.read ? POLLIN : 0) | (wishes.write ? POLLOUT : 0);
    descriptors.push_back({master().number(), static_cast<short>(events), 0});
  }

 private:
  [[nodiscard]] const PtyMaster& master() const { return *transport_.master_; }

  PtyTransport& transport_;
};

PtyTransport::PtyTransport(const std::string& link)
    : master_{std::make_unique<PtyMaster>()}, link_{link} {
  link_.point_to(master_->device());
}

std::unique_ptr<Connection> PtyTransport::accept() {
  if (accepted_ || !master_->in_use()) return nullptr;
  accepted_ = true;
  return std::make_unique<Sender>(*this);
}

/// Prepares the port for the next sender. If the last sender keeps the port open, its terminal is
/// closed, which disconnects it, and the link points to a new terminal. If the last sender has
/// closed the port, the terminal stays.
void PtyTransport::release() {
  accepted_ = false;
  try {
    if (!master_->in_use()) return master_->flush();
    auto fresh = std::make_unique<PtyMaster>();
    link_.point_to(fresh->device());
    master_ = std::move(fresh);
  } catch (const std::exception&) {
    // If no new terminal or link can be made, the old one stays in use.
  }
}

}  // namespace sim
