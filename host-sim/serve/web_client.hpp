#pragma once

#include <poll.h>

#include <chrono>
#include <cstddef>
#include <future>
#include <optional>
#include <string>
#include <vector>

#include "hal/host/descriptor.hpp"
#include "host-sim/serve/http_request.hpp"
#include "host-sim/serve/web_reply.hpp"
#include "host-sim/serve/web_socket.hpp"

namespace sim {

/// A connection of HTTP until its one request is answered or has become a WebSocket. No call
/// blocks; a client that is slow or silent costs a descriptor until its time is over.
class WebClient {
 public:
  using Clock = std::chrono::steady_clock;
  static constexpr std::size_t kMostHead = std::size_t{16} << 10;
  /// For all of the head; for each part of a body or of an answer.
  static constexpr std::chrono::seconds kPatience{10};

  enum class Stage {
    kHead,       ///< Reads the head.
    kHasHead,    ///< The owner is to say what becomes of it.
    kBody,       ///< Reads the body.
    kHasAll,     ///< The owner is to answer.
    kWorking,    ///< The answer is being made.
    kAnswering,  ///< Sends the answer.
    kOver,
  };

  WebClient(hal::host::Descriptor socket, Clock::time_point now)
      : socket_{std::move(socket)}, until_{now + kPatience} {}

  /// Receives and sends what is possible now.
  void attend(Clock::time_point now);
  [[nodiscard]] Stage stage() const { return stage_; }
  /// Whether nothing but a part of a head has come.
  [[nodiscard]] bool silent() const { return stage_ == Stage::kHead; }
  void add_to(std::vector<pollfd>& descriptors) const;

  /// @pre the head has come
  [[nodiscard]] HttpRequest& request() { return request_; }
  /// Reads the body, as long as it was announced. @pre kHasHead
  void want_body(Clock::time_point now);
  /// @pre kHasHead or kHasAll
  void answer(const WebReply& reply, Clock::time_point now);
  /// Has another thread make the answer. @pre kHasAll
  void work(WebWork make);
  /// The connection as a WebSocket. @pre kHasHead, for a handshake that was judged
  [[nodiscard]] WebSocket become_socket();

 private:
  void receive(Clock::time_point now);
  void read_head(Clock::time_point now);
  void end_body();
  void send(Clock::time_point now);

  hal::host::Descriptor socket_;
  Clock::time_point until_;
  Stage stage_ = Stage::kHead;
  std::string received_;  ///< And not taken: the head, then the body.
  std::string to_send_;
  HttpRequest request_{};
  std::size_t body_bytes_ = 0;
  bool only_head_ = false;
  std::future<WebReply> work_;
};

}  // namespace sim
