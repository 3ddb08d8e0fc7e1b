#pragma once

#include <chrono>
#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "host-sim/send/job_lines.hpp"
#include "host-sim/send/sender.hpp"
#include "host-sim/send/take_up.hpp"
#include "host-sim/serve/session.hpp"

namespace sim {

/// A job that the server itself sends: it goes on whoever watches, and ends as a job of
/// `kerfline send` does, because the same `Sender` drives it. Every line has a number, so that a
/// job that was interrupted is taken up again where its beam went out.
class ServedJob {
 public:
  using Clock = std::chrono::steady_clock;
  enum class State : std::uint8_t {
    kNone,
    kLoaded,
    kRunning,
    kStopped,  ///< trouble() says why.
    kDone,
  };

  /// @pre !running()
  void load(std::string name, std::string program);
  /// From the first line. @pre loaded() && !running()
  void run(Clock::time_point now);
  /// From where the machine was interrupted. @pre the same
  void resume(Clock::time_point now);
  /// Holds, and resets at standstill: the place stays known.
  void stop();

  [[nodiscard]] State state() const { return state_; }
  [[nodiscard]] bool running() const { return state_ == State::kRunning; }
  [[nodiscard]] bool loaded() const { return state_ != State::kNone; }
  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] const std::shared_ptr<const std::string>& program() const { return program_; }
  /// Lines that were answered, and of how many.
  [[nodiscard]] std::size_t done() const { return done_; }
  [[nodiscard]] std::size_t count() const { return lines_.size(); }
  /// The line of the file that comes next.
  [[nodiscard]] std::size_t file_line() const;
  [[nodiscard]] const std::string& trouble() const { return trouble_; }

  // While it runs.

  /// What the controller says.
  void hear(std::span<const std::byte> bytes, Clock::time_point now);
  /// Sends what the controller has capacity for.
  void attend(Session& session, Clock::time_point now);

 private:
  enum class Phase : std::uint8_t { kAsking, kApproaching, kSending };

  static Sender::Time time_of(Clock::time_point now) {
    return std::chrono::duration_cast<Sender::Time>(now.time_since_epoch());
  }
  void enter(Phase phase, std::vector<JobLine> lines, Clock::time_point now);
  void begin();
  void end_phase(Clock::time_point now);
  void approach(Clock::time_point now);
  void end(State state, std::string trouble);

  State state_ = State::kNone;
  std::string name_;
  std::shared_ptr<const std::string> program_;
  std::vector<JobLine> lines_;
  std::size_t first_ = 0;  ///< The line with which it began this time.
  std::size_t done_ = 0;
  std::string trouble_;
  Phase phase_ = Phase::kSending;
  Standing standing_{};
  std::vector<JobLine> rest_;  ///< Lines of the job from `first_` on, for after the approach.
  std::optional<Sender> sender_;
};

}  // namespace sim
