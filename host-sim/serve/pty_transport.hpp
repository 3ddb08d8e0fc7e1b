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
/// Raw before a sender can write: a terminal that echoes would send the
/// controller its own greeting back as commands. The other end is not kept
/// open, so the kernel says when a sender opens and closes it.
class PtyMaster {
 public:
  /// Throws std::system_error.
  PtyMaster();

  [[nodiscard]] int number() const { return master_.number(); }
  /// The device that a sender opens.
  [[nodiscard]] const std::string& device() const { return device_; }
  /// A sender has it open, or left bytes behind.
  [[nodiscard]] bool in_use() const;
  /// Forgets what was on its way in both directions. Throws std::system_error.
  void flush() const;

 private:
  hal::host::Descriptor master_;
  std::string device_;
};

/// A symbolic link to the pseudo terminal, for senders that want a name that
/// stays. Removed at the end, if it still is ours.
class PtyLink {
 public:
  explicit PtyLink(std::string path) : path_{std::move(path)} {}
  PtyLink(const PtyLink&) = delete;
  PtyLink& operator=(const PtyLink&) = delete;
  ~PtyLink() { remove(); }

  /// Points to this device from now on, without a moment in which there is no
  /// link. Throws std::system_error, or std::invalid_argument when something
  /// else than the link of a run that has ended has that name.
  void point_to(const std::string& device);
  [[nodiscard]] const std::string& path() const { return path_; }

 private:
  void remove() const;

  std::string path_;
  std::string device_;
};

/// A serial port that is none. One sender at a time can be told from another
/// only by its closing the port; two that open it together share it, as they
/// would a real one.
class PtyTransport final : public Transport {
 public:
  /// Throws as PtyLink::point_to().
  explicit PtyTransport(const std::string& link);

  [[nodiscard]] std::unique_ptr<Connection> accept() override;
  /// Nothing: opening the port wakes nobody, so look now and then.
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
