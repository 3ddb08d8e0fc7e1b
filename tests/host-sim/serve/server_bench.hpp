#pragma once

#include <atomic>
#include <chrono>
#include <csignal>
#include <memory>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "host-sim/serve/reception.hpp"
#include "host-sim/serve/server.hpp"
#include "host-sim/serve/session.hpp"
#include "host-sim/serve/web_routes.hpp"
#include "host-sim/serve/web_transport.hpp"

namespace sim {

/// State of the machine and of its sender, as the loop has it in each cycle.
struct LoopState {
  std::atomic<cnc::MachineState> machine{cnc::MachineState::kIdle};
  std::atomic<bool> lit{false};
  std::atomic<bool> has_sender{false};
};

/// Observes the loop from inside: in each cycle the loop calls this transport for new senders, and
/// receives none.
class LoopProbe final : public Transport {
 public:
  LoopProbe(LoopState& state, const Session& session, const Reception& reception)
      : state_{state}, session_{session}, reception_{reception} {}

  std::unique_ptr<Connection> accept() override {
    state_.machine = session_.controller().machine().state();
    state_.lit = session_.controller().port().power > 0;
    state_.has_sender = !reception_.sender_kind().empty();
    return nullptr;
  }
  void add_to(std::vector<pollfd>&) const override {}
  [[nodiscard]] std::string_view kind() const override { return "probe"; }
  [[nodiscard]] std::string address() const override { return "nowhere"; }

 private:
  LoopState& state_;
  const Session& session_;
  const Reception& reception_;
};

/// `Server::run` in a separate thread, with a laser, a connection for a sender, and the page.
class ServerBench {
 public:
  using Clock = std::chrono::steady_clock;

  /// @param way transport of the sender; null if it connects to the page's port
  explicit ServerBench(std::unique_ptr<Transport> way) {
    if (way) reception_.add(std::move(way));
    auto web = std::make_unique<WebTransport>(InternetAddress{}, routes_);
    page_ = parse_address(web->address());
    session_.controller().add_sink(view_);
    server_.show(view_, *web);
    reception_.set_job(job_);
    reception_.add(std::move(web));
    reception_.add(std::make_unique<LoopProbe>(state_, session_, reception_));
    loop_ = std::thread{[this] {
      loop_thread_ = ::gettid();
      server_.run(stop_);
    }};
  }
  ServerBench(const ServerBench&) = delete;
  ServerBench& operator=(const ServerBench&) = delete;
  ~ServerBench() {
    ::kill(::getpid(), SIGTERM);  // SIGTERM is blocked, and the loop reads it.
    loop_.join();
  }

  [[nodiscard]] const InternetAddress& page() const { return page_; }
  [[nodiscard]] cnc::MachineState state() const { return state_.machine; }
  [[nodiscard]] bool lit() const { return state_.lit; }
  [[nodiscard]] bool has_sender() const { return state_.has_sender; }
  [[nodiscard]] pid_t loop_thread() const { return loop_thread_; }
  /// Waits until `done` holds; returns false after 20 s.
  template <typename Done>
  [[nodiscard]] static bool wait(Done&& done) {
    const auto end = Clock::now() + std::chrono::seconds{20};
    while (!done()) {
      if (Clock::now() > end) return false;
      std::this_thread::sleep_for(std::chrono::microseconds{100});
    }
    return true;
  }

 private:
  static std::vector<SettingChange> laser() {
    return {{.number = 32, .value = 1.0F, .place = "test"},
            {.number = 858, .value = 0.0F, .place = "test"}};
  }

  const StopSignals stop_;
  hal::host::MemoryStore store_;
  Session session_{MachineModel{}, laser(), store_};
  ServedJob job_;
  LiveView view_{session_.controller(), job_};
  Reception reception_{session_};
  WebRoutes routes_{session_.controller(), view_, reception_, job_};
  Server server_{session_, reception_, 1.0};
  InternetAddress page_{};
  LoopState state_{};
  std::atomic<pid_t> loop_thread_{0};
  std::thread loop_;  ///< The last member, because it uses the others.
};

}  // namespace sim
