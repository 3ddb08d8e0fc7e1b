#pragma once

#include <atomic>
#include <chrono>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "host-sim/serve/pacer.hpp"
#include "host-sim/serve/reception.hpp"
#include "host-sim/serve/session.hpp"

namespace sim {

/// The loop of `kerfline serve` in a thread of its own, on a laser, with one transport.
class LoopBench {
 public:
  using Clock = std::chrono::steady_clock;

  explicit LoopBench(std::unique_ptr<Transport> transport) {
    reception_.add(std::move(transport));
    loop_ = std::thread{[this] { run(); }};
  }
  LoopBench(const LoopBench&) = delete;
  LoopBench& operator=(const LoopBench&) = delete;
  ~LoopBench() {
    ends_ = true;
    loop_.join();
  }

  [[nodiscard]] cnc::MachineState state() const { return state_; }
  [[nodiscard]] bool lit() const { return lit_; }
  [[nodiscard]] bool has_sender() const { return has_sender_; }
  /// How often the loop has slept, a millisecond at most each time.
  [[nodiscard]] unsigned sleeps() const { return sleeps_; }
  /// Waits until `done` holds; false after 20 s.
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
  void run() {
    Pacer pacer{1.0, Pacer::Clock::now()};
    while (!ends_) {
      for (auto turns = pacer.take_due(Pacer::Clock::now()); turns > 0; --turns) session_.turn();
      reception_.attend(Clock::now());
      const cnc::Machine& machine = session_.controller().machine();
      state_ = machine.state();
      lit_ = session_.controller().port().power > 0;
      has_sender_ = !reception_.sender_kind().empty();
      descriptors_.clear();
      reception_.add_to(descriptors_);
      ::poll(descriptors_.data(), descriptors_.size(), 1);
      ++sleeps_;
    }
  }

  static std::vector<SettingChange> laser() {
    return {{.number = 32, .value = 1.0F, .place = "test"},
            {.number = 858, .value = 0.0F, .place = "test"}};
  }

  hal::host::MemoryStore store_;
  Session session_{MachineModel{}, laser(), store_};
  Reception reception_{session_};
  std::vector<pollfd> descriptors_;
  std::atomic<cnc::MachineState> state_{cnc::MachineState::kIdle};
  std::atomic<bool> lit_{false};
  std::atomic<bool> has_sender_{false};
  std::atomic<bool> ends_{false};
  std::atomic<unsigned> sleeps_{0};
  std::thread loop_;  ///< The last member: it uses the others.
};

}  // namespace sim
