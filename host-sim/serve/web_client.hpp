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

/// A connection of HTTP, read and written by Boost.Beast. It exists until its single request is
/// answered, or until it has become a WebSocket. No call blocks. A slow or silent client occupies
/// only a descriptor, until its time limit has passed. The handlers of this object run in calls of
/// the transport to its `io_context`. Each handler keeps this object alive.
class WebClient : public std::enable_shared_from_this<WebClient> {
 public:
  using Clock = std::chrono::steady_clock;
  static constexpr std::size_t kMaxHead = std::size_t{16} << 10;
  static constexpr std::size_t kMaxBody = std::size_t{64} << 20;
  /// Time limit for the whole head, for each part of a body, and for each part of an answer.
  static constexpr std::chrono::seconds kPatience{10};

  enum class Stage {
    kHead,     ///< Reads the head.
    kHasHead,  ///< The head was read. The owner must call want_body(), answer() or become_socket().
    kBody,     ///< Reads the body.
    kHasAll,   ///< The body was read, too. The owner must call answer() or work().
    kWorking,  ///< A thread makes the answer.
    kAnswering,  ///< Sends the answer.
    kOver,
  };

  /// @param context must outlive this object
  WebClient(boost::asio::io_context& context, hal::host::Descriptor socket, Clock::time_point now);

  /// Starts to read the head. Must be called once.
  void begin();
  /// Sends the answer when its thread has finished, and checks the time limit.
  void attend(Clock::time_point now);
  [[nodiscard]] Stage stage() const { return stage_; }
  void add_to(std::vector<pollfd>& descriptors);

  /// Returns the request. @pre the head has been read
  [[nodiscard]] HttpRequest& request() { return request_; }
  /// Starts to read the body, up to the length that the head announced. @pre kHasHead
  void want_body();
  /// Sends the answer. @pre kHasHead or kHasAll
  void answer(const WebReply& reply);
  /// Makes the answer in another thread. @pre kHasAll
  void work(WebWork make);
  /// Turns the connection into a WebSocket. Returns null if the handshake is malformed; the client
  /// has been answered in that case. @pre kHasHead
  [[nodiscard]] std::shared_ptr<WebSocket> become_socket();
  void hang_up();

 private:
  using Fault = boost::beast::error_code;
  using Response = boost::beast::http::response<boost::beast::http::string_body>;

  using Handler = std::function<void(Fault, std::size_t)>;

  /// Returns a handler that calls the member function `next` when an operation is over.
  [[nodiscard]] Handler then(void (WebClient::*next)(Fault));
  void end_head(Fault fault);
  void read_body(Fault fault);
  void refuse(Fault fault);
  void send();
  void sent(Fault fault);
  void drop_the_rest();
  void dropped(Fault fault);

  boost::asio::ip::tcp::socket socket_;
  boost::beast::flat_buffer buffer_;  ///< Bytes that were received and not parsed yet.
  boost::beast::http::request_parser<boost::beast::http::string_body> parser_;
  HttpRequest request_{};
  std::future<WebReply> work_;
  Response response_;
  std::optional<boost::beast::http::response_serializer<boost::beast::http::string_body>> sender_;
  Clock::time_point until_;
  Stage stage_ = Stage::kHead;
  /// Whether a part was read or sent since attend() last checked the time.
  bool progressed_ = false;
  bool sent_all_ = false;
  bool left_ = false;  ///< Whether the client has closed its direction.
};

}  // namespace sim
