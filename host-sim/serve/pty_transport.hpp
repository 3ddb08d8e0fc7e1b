#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "hal/host/descriptor.hpp"
#include "host-sim/serve/transport.hpp"

namespace sim {

/// The controller's end of a pseudo terminal.
///
/// The terminal is made raw before a sender can write: a terminal that echoes would send the
/// controller's own greeting back to it as commands. The sender's end is not kept open here, so
/// that the kernel reports when a sender opens and closes it.
class PtyMaster {
 public:
  /// Throws std::system_error.
  PtyMaster();

  [[nodiscard]] int number() const { return master_.number(); }
  /// Returns the path of the device that a sender opens.
  [[nodiscard]] const std::string& device() const { return device_; }
  /// Returns whether a sender has the device open, or has left bytes in it.
  [[nodiscard]] bool in_use() const;
  /// Drops the bytes that wait in both directions. Throws std::system_error.
  void flush() const;

 private:
  hal::host::Descriptor master_;
  std::string device_;
};

/// A symbolic link to the pseudo terminal, for senders that require a fixed name. The destructor
/// removes the link if it still points to this terminal.
class PtyLink {
 public:
  explicit PtyLink(std::string path) : path_{std::move(path)} {}
  PtyLink(const PtyLink&) = delete;
  PtyLink& operator=(const PtyLink&) = delete;
  ~PtyLink() { remove(); }

  /// Makes the link point to this device. The link exists at every moment during the change. Throws
  /// std::system_error, or std::invalid_argument if a file of this name exists and is no link that
  /// an earlier run has left.
  void point_to(const std::string& device);
  [[nodiscard]] const std::string& path() const { return path_; }

 private:
  void remove() const;

  std::string path_;
  std::string device_;
};

/// A serial port that exists only in software. The transport distinguishes two senders only if the
/// first closes the port before the second opens it. Senders that have the port open at the same
/// time share it, as with a real port.
class PtyTransport final : public Transport {
 public:
  /// Throws as PtyLink::point_to() does.
  explicit PtyTransport(const std::string& link);

  [[nodiscard]] std::unique_ptr<Connection> accept() override;
  /// Adds nothing, because no event reports that a program opens the port. The loop has to check
  /// the port periodically.
  void add_to(std::vector<pollfd>&) const override {}
  [[nodiscard]] std::string_view kind() const override { return "pty"; }
  [[nodiscard]] std::string address() const override { return link_.path(); }

 private:
  class Sender;

  void release();

  std::unique_ptr<PtyMaster> master_;
  PtyLink link_;
  bool accepted_ = false;
};

}  // namespace sim
