#pragma once

#include <poll.h>

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/core/error.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/http/parser.hpp>
#include <boost/beast/http/serializer.hpp>
#include <boost/beast/http/string_body.hpp>
#include <chrono>
#include <cstddef>
#include <functional>
#include <future>
#include <memory>
#include <optional>
#include <vector>

#include "hal/host/descriptor.hpp"
#include "host-sim/serve/http_request.hpp"
#include "host-sim/serve/web_reply.hpp"
#include "host-sim/serve/web_socket.hpp"

namespace sim {

/// A connection of HTTP, read and written by Boost.Beast, until its one request is answered or has
/// become a WebSocket. No call blocks; a client that is slow or silent costs a descriptor until
/// its time is over. Handlers run where the transport runs those of its `io_context`; each keeps
/// the client alive.
class WebClient : public std::enable_shared_from_this<WebClient> {
 public:
  using Clock = std::chrono::steady_clock;
  static constexpr std::size_t kMostHead = std::size_t{16} << 10;
  static constexpr std::size_t kMostBody = std::size_t{64} << 20;
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

  /// The context must outlive it.
  WebClient(boost::asio::io_context& context, hal::host::Descriptor socket, Clock::time_point now);

  /// Reads the head. To be called once.
  void begin();
  /// Sees to its work and to its time.
  void attend(Clock::time_point now);
  [[nodiscard]] Stage stage() const { return stage_; }
  void add_to(std::vector<pollfd>& descriptors);

  /// @pre the head has come
  [[nodiscard]] HttpRequest& request() { return request_; }
  /// Reads the body, as long as it was announced. @pre kHasHead
  void want_body();
  /// @pre kHasHead or kHasAll
  void answer(const WebReply& reply);
  /// Has another thread make the answer. @pre kHasAll
  void work(WebWork make);
  /// The connection as a WebSocket; null when the handshake is malformed, and is answered so.
  /// @pre kHasHead
  [[nodiscard]] std::shared_ptr<WebSocket> become_socket();
  void hang_up();

 private:
  using Fault = boost::beast::error_code;
  using Response = boost::beast::http::response<boost::beast::http::string_body>;

  using Handler = std::function<void(Fault, std::size_t)>;

  /// Goes on with this member when an operation is over.
  [[nodiscard]] Handler then(void (WebClient::*next)(Fault));
  void end_head(Fault fault);
  void read_body(Fault fault);
  void refuse(Fault fault);
  void send();
  void sent(Fault fault);
  void drop_the_rest();
  void dropped(Fault fault);

  boost::asio::ip::tcp::socket socket_;
  boost::beast::flat_buffer buffer_;  ///< What was received and not parsed.
  boost::beast::http::request_parser<boost::beast::http::string_body> parser_;
  HttpRequest request_{};
  std::future<WebReply> work_;
  Response response_;
  std::optional<boost::beast::http::response_serializer<boost::beast::http::string_body>> sender_;
  Clock::time_point until_;
  Stage stage_ = Stage::kHead;
  bool progressed_ = false;  ///< Since the last look at the clock.
  bool sent_all_ = false;
  bool left_ = false;  ///< The client sends nothing more.
};

}  // namespace sim
