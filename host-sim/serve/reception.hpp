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

/// Connects one sender at a time to the controller, and carries the bytes between them. A sender
/// that connects meanwhile gets a line with the reason and is disconnected.
///
/// The sender's stream is always read to its end, so that its realtime bytes act and its end is
/// noticed, however many lines wait. A sender that is more than 64 MiB ahead is disconnected.
///
/// A sender is greeted kGreetAfter after its arrival, because many senders flush their port just
/// after opening it. Bytes that the sender sends before the greeting wait for it.
///
/// While a job of the server runs, the job is the sender. A page that operates the machine may
/// connect and disconnect meanwhile: its realtime bytes act, and its lines are refused.
///
/// A page gets a key in its first line, `[PAGE:…]`, with which it orders jobs over HTTP.
class Reception {
 public:
  using Clock = std::chrono::steady_clock;
  static constexpr std::chrono::milliseconds kGreetAfter{120};
  /// Time that a refused sender has to read the reason.
  static constexpr std::chrono::milliseconds kFarewell{500};
  static constexpr std::string_view kRefusal = "[MSG:Another sender is connected]\r\n";
  static constexpr std::string_view kJobRuns = "[MSG:A job of the page runs]\r\n";
  static constexpr std::string_view kTooFarAhead =
      "[MSG:More than 64 MiB of lines wait for the machine: the sender is disconnected]\r\n";
  static constexpr std::string_view kOnlyRealtime =
      "[MSG:0: a job runs: only realtime commands act]\r\nerror:8\r\n";
  /// Kinds of senders: a page, and the server's job.
  static constexpr std::string_view kPage = "page";
  static constexpr std::string_view kJob = "job";

  /// @param session must outlive this object
  explicit Reception(Session& session) : session_{session} {}

  void add(std::unique_ptr<Transport> transport) { ways_in_.push_back(std::move(transport)); }
  [[nodiscard]] const std::vector<std::unique_ptr<Transport>>& ways_in() const { return ways_in_; }
  /// Sets the job that the server may run. The job must outlive this object.
  void set_job(ServedJob& job) { job_ = &job; }

  /// Serves all connections, without blocking.
  void attend(Clock::time_point now);
  /// Adds the descriptors and events for which poll() is to wake up.
  void add_to(std::vector<pollfd>& descriptors);
  /// Returns the kind of the sender: `pty`, `tcp`, `ws`, `page`, `can`, `slcan`, or `job` for a job
  /// without an operator; empty if there is no sender.
  [[nodiscard]] std::string_view sender_kind() const;
  /// Returns whether the page with this key controls the machine.
  [[nodiscard]] bool is_operator(std::string_view page_key) const {
    return sender_ && greeted_ && sender_kind_ == kPage && page_key == page_key_;
  }
  /// Holds the feed. Any operator that sees the machine may request this, with or without control,
  /// because it is safe.
  void hold() { session_.act_at_once(std::byte{'!'}); }

 private:
  struct Arrival {
    std::unique_ptr<Connection> connection;
    std::string_view kind;
  };
  struct Departing {
    std::unique_ptr<Connection> connection;
    Clock::time_point until;
    std::string_view words;  ///< Rest of the reason that has not been sent yet.
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
  // Declared after `ways_in_`, because connections refer to their transports.
  std::unique_ptr<Connection> sender_;
  LookAhead look_ahead_{};       ///< Look-ahead in the sender's stream.
  std::vector<std::byte> part_;  ///< Bytes that were read last.
  std::vector<Departing> departing_;
  std::string_view sender_kind_;
  std::string page_key_;  ///< Key of the page that connected last.
  Clock::time_point greet_at_;
  bool greeted_ = false;  ///< Whether the session has a greeted sender: a connection or a job.
};

}  // namespace sim
