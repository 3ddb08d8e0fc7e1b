#include "host-sim/serve/served_job.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "planner/base/contract.hpp"

namespace sim {

void ServedJob::collect() {
  ProgramInbox::Arrival arrival = inbox_->take();
  if (!arrival.program || running()) return;
  load(std::move(arrival.program));
  judged_ = std::move(arrival.judged);
}

void ServedJob::load(std::shared_ptr<const ServedProgram> program) {
  CNC_ASSERT(!running());
  program_ = std::move(program);
  first_ = done_ = 0;
  trouble_.clear();
  state_ = State::kLoaded;
}

void ServedJob::begin() {
  CNC_ASSERT(loaded() && !running());
  trouble_.clear();
  motion_.clear();
  state_ = State::kRunning;
}

/// Returns a part of the job. The part shares ownership of the program, which holds the lines.
JobPart ServedJob::part_from(std::size_t first, std::string motion) const {
  return {.lines = std::shared_ptr<const JobLines>{program_, &program_->lines},
          .first = first,
          .motion = std::move(motion)};
}

void ServedJob::run(Clock::time_point now) {
  begin();
  first_ = done_ = 0;
  enter(Phase::kSending, part_from(0, {}), now);
}

void ServedJob::resume(Clock::time_point now) {
  begin();
  standing_ = {};
  enter(Phase::kAsking, standing_questions(true), now);
}

void ServedJob::stop() {
  if (sender_) return sender_->abort();
  // The job is being planned, and no sender exists yet.
  if (running()) end(State::kStopped, "aborted");
}

std::size_t ServedJob::file_line() const {
  return done_ < count() ? program_->lines.number_of(done_) : 0;
}

void ServedJob::enter(Phase phase, const std::vector<JobLine>& lines, Clock::time_point now) {
  enter(phase, JobPart{.lines = std::make_shared<const JobLines>(lines)}, now);
}

void ServedJob::enter(Phase phase, JobPart part, Clock::time_point now) {
  phase_ = phase;
  sender_.emplace(
      std::move(part),
      SendOptions{.takes_up = phase != Phase::kSending, .rests_in_alarm = phase != Phase::kSending},
      time_of(now));
  if (phase != Phase::kAsking) return;
  sender_->on_line = [this](char way, std::string_view words) {
    if (way == '<') standing_.read(words);
  };
}

void ServedJob::hear(std::span<const std::byte> bytes, Clock::time_point now) {
  if (!sender_) return;
  sender_->receive({reinterpret_cast<const char*>(bytes.data()), bytes.size()}, time_of(now));
}

void ServedJob::attend(Session& session, Clock::time_point now) {
  if (running() && phase_ == Phase::kPlanning) attend_plan(now);
  if (!sender_) return;
  sender_->attend(time_of(now));
  const std::string_view realtime = sender_->realtime();
  for (const char byte : realtime) session.act_at_once(static_cast<std::byte>(byte));
  sender_->acted(realtime.size());
  for (;;) {
    const std::string_view bytes = sender_->output();
    const std::size_t count = std::min(bytes.size(), session.link().room());
    if (count == 0) break;
    session.link().receive(std::as_bytes(std::span{bytes}).first(count));
    sender_->wrote(count);
  }
  if (phase_ == Phase::kSending) done_ = std::min(first_ + sender_->answered(), count());
  if (sender_->over()) end_phase(now);
}

void ServedJob::end_phase(Clock::time_point now) {
  if (sender_->state() == Sender::State::kFailed) return end(State::kStopped, sender_->trouble());
  switch (phase_) {
    case Phase::kAsking:
      return begin_plan();
    case Phase::kPlanning:
      return;
    case Phase::kApproaching:
      return enter(Phase::kSending, part_from(first_, motion_), now);
    case Phase::kSending:
      return end(State::kDone, {});
  }
}

/// Starts to plan the resumption in another thread, which reads all lines before the interruption.
void ServedJob::begin_plan() {
  sender_.reset();
  phase_ = Phase::kPlanning;
  plan_.start([program = program_, standing = standing_](const std::atomic<bool>&) {
    return plan(program->lines, standing);
  });
}

ServedJob::Plan ServedJob::plan(const JobLines& lines, const Standing& standing) {
  Plan plan;
  try {
    plan.first = interrupted_at(lines, standing);
    plan.approach = lines_before(lines, plan.first, standing, true);
  } catch (const std::invalid_argument& fault) {
    plan.trouble = fault.what();
  }
  return plan;
}

void ServedJob::attend_plan(Clock::time_point now) {
  std::optional<Plan> plan = plan_.take();
  if (!plan) return;
  if (!plan->trouble.empty()) return end(State::kStopped, std::move(plan->trouble));
  first_ = done_ = plan->first;
  motion_ = std::move(plan->approach.motion);
  enter(Phase::kApproaching, plan->approach.lines, now);
}

void ServedJob::end(State state, std::string trouble) {
  state_ = state;
  trouble_ = std::move(trouble);
  plan_.abandon();
  sender_.reset();
}

}  // namespace sim
