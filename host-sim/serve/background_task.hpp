#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <thread>
#include <utility>
#include <vector>

#include "host-sim/serve/background_priority.hpp"

namespace sim {

/// Runs long work in a separate thread, for a loop that must not wait. The work uses copies of its
/// inputs. Only the result of the last started work is kept. Abandoned work continues until it
/// checks its flag `cancelled`.
template <typename Result>
class BackgroundTask {
 public:
  /// Function that does the work. It must not throw.
  using Work = std::function<Result(const std::atomic<bool>& cancelled)>;

  BackgroundTask() = default;
  BackgroundTask(const BackgroundTask&) = delete;
  BackgroundTask& operator=(const BackgroundTask&) = delete;
  /// Cancels all work and waits until all threads have ended.
  ~BackgroundTask() { abandon(); }

  /// Abandons earlier work and starts `work` in a new thread.
  void start(Work work) {
    abandon();
    std::erase_if(threads_, [](const Running& one) { return one.shared->done.load(); });
    current_ = std::make_shared<Shared>();
    threads_.push_back({current_, std::jthread{[shared = current_, work = std::move(work)] {
                          work_in_background();
                          shared->result.emplace(work(shared->cancelled));
                          shared->done = true;
                        }}});
  }
  void abandon() {
    if (current_) current_->cancelled = true;
    current_.reset();
  }
  [[nodiscard]] bool running() const { return current_ != nullptr; }
  /// Returns the result of the finished work once; nothing before that and afterwards.
  [[nodiscard]] std::optional<Result> take() {
    if (!current_ || !current_->done) return std::nullopt;
    const std::shared_ptr<Shared> finished = std::exchange(current_, nullptr);
    return std::move(finished->result);
  }

 private:
  struct Shared {
    std::atomic<bool> cancelled{false};
    std::atomic<bool> done{false};
    std::optional<Result> result{};
  };
  struct Running {
    std::shared_ptr<Shared> shared;
    std::jthread thread;
  };

  std::shared_ptr<Shared> current_;
  std::vector<Running> threads_;  ///< Threads of the current work and of abandoned work.
};

}  // namespace sim
