#pragma once

#include <vector>

#include "hal/host/descriptor.hpp"
#include "host-sim/serve/live_view.hpp"
#include "host-sim/serve/pacer.hpp"
#include "host-sim/serve/reception.hpp"
#include "host-sim/serve/session.hpp"
#include "host-sim/serve/web_transport.hpp"

namespace sim {

/// SIGINT, SIGTERM and SIGHUP as a descriptor for poll(). Create it before any other thread, so
/// that the signals are blocked in all threads.
class StopSignals {
 public:
  StopSignals();
  [[nodiscard]] int number() const { return descriptor_.number(); }
  [[nodiscard]] bool arrived() const;

 private:
  hal::host::Descriptor descriptor_;
};

/// The loop of `kerfline serve`: one thread for the controller and all its connections, which
/// sleeps in poll() between the cycles.
class Server {
 public:
  /// @param session must outlive this object
  /// @param reception must outlive this object
  /// @param speed controller seconds per second
  Server(Session& session, Reception& reception, double speed)
      : session_{session}, reception_{reception}, pacer_{speed, Pacer::Clock::now()} {}

  /// Shows this view to the watchers. Both arguments must outlive the server.
  void show(LiveView& view, WebTransport& web) {
    view_ = &view;
    web_ = &web;
  }

  /// Runs until a signal stops it.
  void run(const StopSignals& stop);

 private:
  /// Runs the cycles that are due. Each round of the server loop begins with this call. So bytes
  /// that arrive in this round do not act in cycles that were due before.
  void catch_up();
  void show_view();
  void sleep(const StopSignals& stop);

  Session& session_;
  Reception& reception_;
  Pacer pacer_;
  LiveView* view_ = nullptr;  ///< View for the watchers; null without a page.
  WebTransport* web_ = nullptr;
  std::vector<pollfd> descriptors_;
};

}  // namespace sim
