#include "host-sim/serve/served_job.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "planner/base/contract.hpp"

namespace sim {

void ServedJob::load(std::string name, std::string program) {
  CNC_ASSERT(!running());
  name_ = std::move(name);
  program_ = std::make_shared<const std::string>(std::move(program));
  lines_ = read_job(*program_);
  number_lines(lines_);
  first_ = done_ = 0;
  trouble_.clear();
  state_ = State::kLoaded;
}

void ServedJob::begin() {
  CNC_ASSERT(loaded() && !running());
  trouble_.clear();
  state_ = State::kRunning;
}

void ServedJob::run(Clock::time_point now) {
  begin();
  first_ = done_ = 0;
  enter(Phase::kSending, lines_, now);
}

void ServedJob::resume(Clock::time_point now) {
  begin();
  standing_ = {};
  enter(Phase::kAsking, standing_questions(true), now);
}

void ServedJob::stop() {
  if (sender_) sender_->abort();
}

std::size_t ServedJob::file_line() const {
  return done_ < lines_.size() ? lines_[done_].number : 0;
}

void ServedJob::enter(Phase phase, std::vector<JobLine> lines, Clock::time_point now) {
  phase_ = phase;
  sender_.emplace(
      std::move(lines), SendOptions{.takes_up = phase != Phase::kSending}, time_of(now));
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
  if (phase_ == Phase::kSending) done_ = std::min(first_ + sender_->answered(), lines_.size());
  if (sender_->over()) end_phase(now);
}

void ServedJob::end_phase(Clock::time_point now) {
  if (sender_->state() == Sender::State::kFailed) return end(State::kStopped, sender_->trouble());
  switch (phase_) {
    case Phase::kAsking:
      return approach(now);
    case Phase::kApproaching:
      return enter(Phase::kSending, std::move(rest_), now);
    case Phase::kSending:
      return end(State::kDone, {});
  }
}

void ServedJob::approach(Clock::time_point now) {
  try {
    std::vector<JobLine> job = lines_;
    first_ = interrupted_at(job, standing_);
    std::vector<JobLine> before = lines_before(job, first_, standing_, true);
    rest_.assign(job.begin() + static_cast<std::ptrdiff_t>(first_), job.end());
    done_ = first_;
    enter(Phase::kApproaching, std::move(before), now);
  } catch (const std::invalid_argument& fault) {
    end(State::kStopped, fault.what());
  }
}

void ServedJob::end(State state, std::string trouble) {
  state_ = state;
  trouble_ = std::move(trouble);
  sender_.reset();
}

}  // namespace sim
