#include "host-sim/serve/reception.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <random>
#include <utility>

namespace sim {
namespace {

constexpr std::size_t kSenderPart = std::size_t{64} << 10;
// Greatest number of bytes that one call reads. Reading them takes some milliseconds. The machine
// catches up on the cycles of this time.
constexpr std::size_t kMaxAtOnce = std::size_t{4} << 20;

/// Returns a random key, which no other page can guess.
std::string fresh_key() {
  std::random_device random;
  return fmt::format("{:08x}{:08x}{:08x}{:08x}", random(), random(), random(), random());
}

}  // namespace

void Reception::attend(Clock::time_point now) {
  std::vector<Arrival> arrivals = accept_all();
  if (job_ != nullptr) job_->collect();
  if (sender_) {
    greet(now);
    if (greeted_ && session_.hears()) carry_in();
  }
  if (job_runs()) job_->attend(session_, now);
  if (greeted_) carry_out(now);
  look_for_end(now);
  for (Arrival& arrival : arrivals) meet(std::move(arrival), now);
  see_off(now);
}

/// Returns the new connections. They are accepted before the present sender's bytes are read. If
/// the present sender disconnected before they arrived, this is noticed before the new connections
/// are handled.
std::vector<Reception::Arrival> Reception::accept_all() {
  std::vector<Arrival> arrivals;
  for (const auto& way : ways_in_) {
    if (way->take_stop()) session_.emergency_stop();
    while (auto connection = way->accept()) {
      const std::string_view kind = connection->kind();
      arrivals.push_back({std::move(connection), kind.empty() ? way->kind() : kind});
    }
  }
  return arrivals;
}

std::string_view Reception::sender_kind() const {
  if (sender_) return sender_kind_;
  return job_runs() ? kJob : std::string_view{};
}

/// Makes a new connection the sender, or refuses it. While a job runs, only a page is accepted.
void Reception::meet(Arrival arrival, Clock::time_point now) {
  if (sender_ || (job_runs() && arrival.kind != kPage)) {
    const std::string_view reason = sender_ ? kRefusal : kJobRuns;
    departing_.push_back({std::move(arrival.connection), now + kFarewell, reason});
    return;
  }
  sender_ = std::move(arrival.connection);
  sender_kind_ = arrival.kind;
  greet_at_ = now + kGreetAfter;
  if (sender_kind_ == kPage) {
    page_key_ = fresh_key();
    const std::string words = fmt::format("[PAGE:{}]\r\n", page_key_);
    static_cast<void>(sender_->write(std::as_bytes(std::span{words})));
  }
  if (job_runs()) static_cast<void>(sender_->write(std::as_bytes(std::span{kJobRuns})));
}

void Reception::see_off(Clock::time_point now) {
  part_.resize(kSenderPart);
  for (Departing& one : departing_) {
    // Bytes of the refused sender are still read. Otherwise the kernel would send a TCP reset,
    // which discards the reason that is sent to this sender.
    for (std::size_t read = 0; read < kMaxAtOnce; read += kSenderPart) {
      if (one.connection->read(part_) == 0) break;
    }
    if (one.words.empty()) continue;
    one.words.remove_prefix(one.connection->write(std::as_bytes(std::span{one.words})));
    if (one.words.empty()) one.connection->end();
  }
  std::erase_if(departing_, [now](const Departing& one) {
    return now >= one.until || !one.connection->open();
  });
}

void Reception::greet(Clock::time_point now) {
  if (greeted_ || now < greet_at_ || !session_.calm()) return;
  session_.welcome_sender();
  greeted_ = true;
}

/// Reads the sender's stream, including realtime bytes after lines that the controller cannot take
/// yet.
void Reception::carry_in() {
  for (std::byte byte{}; sender_->take_realtime(byte);) session_.act_at_once(byte);
  part_.resize(kSenderPart);
  for (std::size_t read = 0; read < kMaxAtOnce && !look_ahead_.overrun();) {
    const std::size_t count = sender_->read(part_);
    if (count == 0) break;
    look_ahead_.hear(std::span{part_}.first(count), session_);
    read += count;
  }
  if (job_runs()) return refuse_lines();
  look_ahead_.hand_over(session_);
}

/// Refuses the sender's lines. Each line gets an answer, because senders count answers.
void Reception::refuse_lines() {
  const std::string lines = look_ahead_.take_lines(session_);
  for (auto line = std::count(lines.begin(), lines.end(), '\n'); line > 0; --line) {
    static_cast<void>(sender_->write(std::as_bytes(std::span{kOnlyRealtime})));
  }
}

/// Carries the controller's output to the sender and the job. While a job runs, the page misses
/// output that it cannot take at the moment, so that the job does not wait for the page.
void Reception::carry_out(Clock::time_point now) {
  LiveLink& link = session_.link();
  while (!link.outgoing().empty()) {
    std::size_t count = link.outgoing().size();
    if (job_runs()) {
      if (sender_) static_cast<void>(sender_->write(link.outgoing()));
      job_->hear(link.outgoing(), now);
    } else if (sender_) {
      count = sender_->write(link.outgoing());
    }
    if (count == 0) return;
    link.taken(count);
  }
}

void Reception::look_for_end(Clock::time_point now) {
  if (sender_ && look_ahead_.overrun()) {
    departing_.push_back({std::move(sender_), now + kFarewell, kTooFarAhead});
  } else if (sender_ && !sender_->open()) {
    sender_.reset();
  }
  if (sender_) return;
  look_ahead_.forget();
  if (!greeted_ || job_runs()) return;
  greeted_ = false;
  session_.lose_sender();
}

void Reception::add_to(std::vector<pollfd>& descriptors) {
  for (const auto& way : ways_in_) way->add_to(descriptors);
  for (const Departing& one : departing_) one.connection->add_to(descriptors, {.read = true});
  if (!sender_) return;
  const Wishes wishes{.read = greeted_ && session_.hears(),
                      .write = greeted_ && !session_.link().outgoing().empty()};
  if (wishes.read || wishes.write) sender_->add_to(descriptors, wishes);
}

}  // namespace sim
