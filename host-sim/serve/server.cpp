#include "host-sim/serve/server.hpp"

#include <sys/signalfd.h>

#include <algorithm>
#include <csignal>

namespace sim {
namespace {

using hal::host::checked;
using std::chrono::milliseconds;

// Longest sleep while the machine is idle. A sender's bytes wake the loop immediately; only the
// opening of a pty does not.
constexpr milliseconds kRest{10};
constexpr milliseconds kShortestSleep{1};

int signals_to_poll_for() {
  sigset_t signals{};
  sigemptyset(&signals);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) sigaddset(&signals, signal);
  ::pthread_sigmask(SIG_BLOCK, &signals, nullptr);
  return ::signalfd(-1, &signals, SFD_CLOEXEC | SFD_NONBLOCK);
}

}  // namespace

StopSignals::StopSignals() : descriptor_{checked(signals_to_poll_for(), "signalfd")} {}

bool StopSignals::arrived() const {
  signalfd_siginfo signal{};
  return ::read(number(), &signal, sizeof signal) > 0;
}

void Server::run(const StopSignals& stop) {
  while (!stop.arrived()) {
    catch_up();
    reception_.attend(Reception::Clock::now());
    if (view_ != nullptr) show_view();
    sleep(stop);
  }
}

void Server::catch_up() {
  for (std::uint64_t turns = pacer_.take_due(Pacer::Clock::now()); turns > 0; --turns) {
    session_.turn();
  }
}

void Server::show_view() {
  const auto now = LiveView::Clock::now();
  if (view_->due(now)) view_->publish(web_->watchers(), reception_.sender_kind(), now);
}

void Server::sleep(const StopSignals& stop) {
  const auto until_next = pacer_.until_next(Pacer::Clock::now());
  // There is no time to sleep, because the next cycle is due.
  if (until_next == Pacer::Clock::duration::zero()) return;
  descriptors_.assign(1, {stop.number(), POLLIN, 0});
  reception_.add_to(descriptors_);
  const auto wanted = std::chrono::ceil<milliseconds>(until_next);
  const milliseconds time = std::max(wanted, session_.resting() ? kRest : kShortestSleep);
  ::poll(descriptors_.data(), descriptors_.size(), static_cast<int>(time.count()));
}

}  // namespace sim
