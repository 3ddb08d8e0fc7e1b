#pragma once

#include <chrono>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "host-sim/serve/session.hpp"
#include "host-sim/serve/transport.hpp"

namespace sim {

/// Lets one sender at a time at the controller and carries the bytes between
/// them. Whoever comes meanwhile is told so in a line and hung up on.
///
/// A sender is greeted kGreetAfter after it came: many flush their port just
/// after opening it. What it sends before waits for the greeting.
class Reception {
 public:
  using Clock = std::chrono::steady_clock;
  static constexpr std::chrono::milliseconds kGreetAfter{120};
  /// How long one who was refused may take to read why.
  static constexpr std::chrono::milliseconds kFarewell{500};
  static constexpr std::string_view kRefusal = "[MSG:Another sender is connected]\r\n";

  /// The session must outlive it.
  explicit Reception(Session& session) : session_{session} {}

  void add(std::unique_ptr<Transport> transport) { ways_in_.push_back(std::move(transport)); }
  [[nodiscard]] const std::vector<std::unique_ptr<Transport>>& ways_in() const { return ways_in_; }

  /// Looks after everybody, without blocking.
  void attend(Clock::time_point now);
  /// What to wake up for.
  void add_to(std::vector<pollfd>& descriptors);
  /// How the sender came: `pty`, `tcp`, `ws`; empty when there is none.
  [[nodiscard]] std::string_view sender_kind() const { return sender_kind_; }

 private:
  struct Departing {
    std::unique_ptr<Connection> connection;
    Clock::time_point until;
    std::string_view words;  ///< Not sent yet.
  };

  void meet(std::unique_ptr<Connection> connection, const Transport& way, Clock::time_point now);
  void see_off(Clock::time_point now);
  void attend_sender(Clock::time_point now);
  void carry_in();
  void carry_out();

  Session& session_;
  std::vector<std::unique_ptr<Transport>> ways_in_;
  // After the transports, which their connections refer to.
  std::unique_ptr<Connection> sender_;
  std::vector<Departing> departing_;
  std::string_view sender_kind_;
  Clock::time_point greet_at_;
  bool greeted_ = false;
};

}  // namespace sim
