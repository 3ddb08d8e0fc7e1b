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
#include "host-sim/serve/background_task.hpp"
#include "host-sim/serve/served_program.hpp"
#include "host-sim/serve/session.hpp"

namespace sim {

/// A job that the server itself sends. The job continues without a page. It ends under the same
/// conditions as a job of `kerfline send`, because the same `Sender` drives it. Every line has a
/// number, so that an interrupted job can be resumed where its beam went off.
class ServedJob {
 public:
  using Clock = std::chrono::steady_clock;
  enum class State : std::uint8_t {
    kNone,
    kLoaded,
    kRunning,
    kStopped,  ///< trouble() has the reason.
    kDone,
  };

  /// Returns the inbox into which threads put a program that they have prepared. collect() takes it
  /// from there.
  [[nodiscard]] const std::shared_ptr<ProgramInbox>& inbox() const { return inbox_; }
  /// Loads a program that has arrived. A program that arrives while a job runs is dropped.
  void collect();
  /// @pre !running()
  void load(std::shared_ptr<const ServedProgram> program);
  /// Returns the last judgement of the program, if its key is `key`; otherwise null.
  [[nodiscard]] const Judgement* judgement(std::string_view key) const {
    return judged_ && judged_->key == key ? &judged_->judgement : nullptr;
  }
  void keep(Judged judged) { judged_ = std::move(judged); }
  /// Runs the job from its first line. @pre loaded() && !running()
  void run(Clock::time_point now);
  /// Resumes the job where the machine was interrupted. @pre loaded() && !running()
  void resume(Clock::time_point now);
  /// Ends the job: holds, and resets when the machine is at rest. In a state in which a hold has no
  /// effect, resets immediately. The position stays known.
  void stop();

  [[nodiscard]] State state() const { return state_; }
  [[nodiscard]] bool running() const { return state_ == State::kRunning; }
  [[nodiscard]] bool loaded() const { return state_ != State::kNone; }
  /// Returns the program; null if there is none.
  [[nodiscard]] const std::shared_ptr<const ServedProgram>& program() const { return program_; }
  /// Return the number of lines that were answered, and of all lines.
  [[nodiscard]] std::size_t done() const { return done_; }
  [[nodiscard]] std::size_t count() const { return program_ ? program_->lines.size() : 0; }
  /// Returns the number of the line of the file that comes next; 0 after the last line.
  [[nodiscard]] std::size_t file_line() const;
  [[nodiscard]] const std::string& trouble() const { return trouble_; }

  // The following functions are for use while the job runs.

  /// Reads bytes that the controller wrote.
  void hear(std::span<const std::byte> bytes, Clock::time_point now);
  /// Sends the bytes for which the controller has capacity.
  void attend(Session& session, Clock::time_point now);

 private:
  enum class Phase : std::uint8_t { kAsking, kPlanning, kApproaching, kSending };
  /// Plan of a resumption: the lines that move the machine to the line of the interruption, or in
  /// `trouble` the reason why this is impossible.
  struct Plan {
    std::size_t first = 0;
    Approach approach{};
    std::string trouble;
  };

  static Sender::Time time_of(Clock::time_point now) {
    return std::chrono::duration_cast<Sender::Time>(now.time_since_epoch());
  }
  [[nodiscard]] JobPart part_from(std::size_t first, std::string motion) const;
  static Plan plan(const JobLines& lines, const Standing& standing);
  void begin();
  void enter(Phase phase, JobPart part, Clock::time_point now);
  void enter(Phase phase, const std::vector<JobLine>& lines, Clock::time_point now);
  void end_phase(Clock::time_point now);
  void begin_plan();
  void attend_plan(Clock::time_point now);
  void end(State state, std::string trouble);

  State state_ = State::kNone;
  std::shared_ptr<ProgramInbox> inbox_ = std::make_shared<ProgramInbox>();
  std::shared_ptr<const ServedProgram> program_;
  std::optional<Judged> judged_;
  std::size_t first_ = 0;  ///< Index of the line with which the present run of the job began.
  std::string motion_;     ///< Words in front of the line first_, see JobPart.
  std::size_t done_ = 0;
  std::string trouble_;
  Phase phase_ = Phase::kSending;
  Standing standing_{};
  BackgroundTask<Plan> plan_{};
  std::optional<Sender> sender_;
};

}  // namespace sim
