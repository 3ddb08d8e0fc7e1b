#pragma once

#include <chrono>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "host-sim/serve/look_ahead.hpp"
#include "host-sim/serve/served_job.hpp"
#include "host-sim/serve/session.hpp"
#include "host-sim/serve/transport.hpp"

namespace sim {

/// Lets one sender at a time at the controller and carries the bytes between them. A sender that
/// comes meanwhile gets a line with the reason and is hung up on.
///
/// The sender's stream is always read to its end: its realtime bytes act, and its end is
/// noticed, however many lines wait. One that is more than 64 MiB ahead is hung up on.
///
/// A sender is greeted kGreetAfter after it came: many flush their port just
/// after opening it. What it sends before waits for the greeting.
///
/// While a job of the server runs, the job is the sender: of a page that operates the machine
/// realtime bytes act, its lines are refused, and it may come and go.
///
/// A page gets a key in its first line, `[PAGE:…]`, with which it orders jobs over HTTP.
class Reception {
 public:
  using Clock = std::chrono::steady_clock;
  static constexpr std::chrono::milliseconds kGreetAfter{120};
  /// Time for a refused sender to read the reason.
  static constexpr std::chrono::milliseconds kFarewell{500};
  static constexpr std::string_view kRefusal = "[MSG:Another sender is connected]\r\n";
  static constexpr std::string_view kJobRuns = "[MSG:A job of the page runs]\r\n";
  static constexpr std::string_view kTooFarAhead =
      "[MSG:More than 64 MiB of lines wait for the machine: the sender is hung up on]\r\n";
  static constexpr std::string_view kOnlyRealtime =
      "[MSG:0: a job runs: only realtime commands act]\r\nerror:8\r\n";
  /// Kinds of senders: a page, and the job.
  static constexpr std::string_view kPage = "page";
  static constexpr std::string_view kJob = "job";

  /// The session must outlive it.
  explicit Reception(Session& session) : session_{session} {}

  void add(std::unique_ptr<Transport> transport) { ways_in_.push_back(std::move(transport)); }
  [[nodiscard]] const std::vector<std::unique_ptr<Transport>>& ways_in() const { return ways_in_; }
  /// The job that the server may run; must outlive it.
  void set_job(ServedJob& job) { job_ = &job; }

  /// Serves all connections, without blocking.
  void attend(Clock::time_point now);
  /// Adds the events to wake up for.
  void add_to(std::vector<pollfd>& descriptors);
  /// How the sender came: `pty`, `tcp`, `ws`, `page`, `can`, `slcan`, or `job` for a job without
  /// an operator; empty when there is none.
  [[nodiscard]] std::string_view sender_kind() const;
  /// Whether the page with this key controls the machine.
  [[nodiscard]] bool is_operator(std::string_view page_key) const {
    return sender_ && greeted_ && sender_kind_ == kPage && page_key == page_key_;
  }
  /// A feed hold, which is safe for any operator that sees the machine, with control or without.
  void hold() { session_.act_at_once(std::byte{'!'}); }

 private:
  struct Arrival {
    std::unique_ptr<Connection> connection;
    std::string_view kind;
  };
  struct Departing {
    std::unique_ptr<Connection> connection;
    Clock::time_point until;
    std::string_view words;  ///< Not sent yet.
  };

  [[nodiscard]] bool job_runs() const { return job_ != nullptr && job_->running(); }
  [[nodiscard]] std::vector<Arrival> accept_all();
  void meet(Arrival arrival, Clock::time_point now);
  void see_off(Clock::time_point now);
  void greet(Clock::time_point now);
  void carry_in();
  void refuse_lines();
  void carry_out(Clock::time_point now);
  void look_for_end(Clock::time_point now);

  Session& session_;
  ServedJob* job_ = nullptr;
  std::vector<std::unique_ptr<Transport>> ways_in_;
  // After the transports, which their connections refer to.
  std::unique_ptr<Connection> sender_;
  LookAhead look_ahead_{};       ///< Of the sender.
  std::vector<std::byte> part_;  ///< Read last.
  std::vector<Departing> departing_;
  std::string_view sender_kind_;
  std::string page_key_;  ///< Of the last page that came.
  Clock::time_point greet_at_;
  bool greeted_ = false;  ///< The session has a sender, a connection or a job.
};

}  // namespace sim
