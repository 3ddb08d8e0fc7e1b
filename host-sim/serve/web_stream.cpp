#include "host-sim/serve/web_stream.hpp"

#include <algorithm>
#include <array>
#include <boost/beast/websocket.hpp>
#include <deque>
#include <functional>
#include <string>
#include <utility>

namespace sim {
namespace {

namespace websocket = boost::beast::websocket;
using boost::beast::error_code;

constexpr std::size_t kMaxPayload = std::size_t{64} << 20;
// Greatest number of bytes that one call reads from a client. The next part is read when the reader
// has taken all bytes of the previous part.
constexpr std::size_t kStreamPart = std::size_t{64} << 10;

bool is_ascii(std::string_view text) {
  return std::all_of(
      text.begin(), text.end(), [](char byte) { return static_cast<signed char>(byte) >= 0; });
}

/// WebSocket of Boost.Beast, with a queue in each direction. Its handlers run in calls of the
/// transport to its `io_context`. Each handler keeps the stream alive.
class WebStream final : public WebSocket, public std::enable_shared_from_this<WebStream> {
 public:
  explicit WebStream(boost::asio::ip::tcp::socket socket) : stream_{std::move(socket)} {
    stream_.read_message_max(kMaxPayload);
    stream_.auto_fragment(false);
    // A sender counts as disconnected as soon as its close frame has arrived, even if the closing
    // of the connection takes longer.
    stream_.control_callback([this](websocket::frame_type frame, auto) {
      left_ = left_ || frame == websocket::frame_type::close;
    });
  }

  /// Sends the answer to the handshake, whose few bytes always fit into a new connection.
  template <typename Request>
  bool accept(const Request& request) {
    error_code fault;
    stream_.accept(request, fault);
    if (!fault) receive();
    return !fault;
  }

  std::size_t read(std::span<std::byte> into) override {
    const std::size_t count = std::min(into.size(), unread_.size());
    std::copy_n(std::as_bytes(unread_).begin(), count, into.begin());
    unread_ = unread_.subspan(count);
    receive();
    return count;
  }

  std::size_t write(std::span<const std::byte> from) override {
    if (!here() || ended_ || unsent_ >= kMaxUnsent) return 0;
    const std::size_t count = std::min(from.size(), kMaxUnsent - unsent_);
    if (count == 0) return 0;
    messages_.emplace_back(reinterpret_cast<const char*>(from.data()), count);
    unsent_ += count;
    send();
    return count;
  }

  void end() override {
    if (std::exchange(ended_, true)) return;
    send();
  }

  bool open() const override { return here() || !unread_.empty(); }
  bool gone() const override { return gone_; }
  std::size_t unsent() const override { return unsent_; }

  void attend(Clock::time_point now) override {
    const bool parts = ended_ || !here();
    const bool waits = parts || !messages_.empty();
    if (!waits || std::exchange(sent_, false) || parts != std::exchange(parts_, parts)) {
      until_ = now + (parts ? kFarewell : kPatience);
    } else if (now >= until_) {
      hang_up();
    }
  }

  void add_to(std::vector<pollfd>& descriptors) override {
    if (gone_) return;
    const int events = (receives_ ? POLLIN : 0) | (sends_ ? POLLOUT : 0);
    descriptors.push_back({stream_.next_layer().native_handle(), static_cast<short>(events), 0});
  }

 private:
  using Stream = websocket::stream<boost::asio::ip::tcp::socket, false>;

  /// Returns whether the connection is open and the client has not sent its close frame.
  [[nodiscard]] bool here() const { return !gone_ && !left_ && stream_.is_open(); }

  /// Returns a handler that calls the member function `next` when an operation is over.
  std::function<void(error_code, std::size_t)> then(void (WebStream::*next)(error_code,
                                                                            std::size_t)) {
    return [self = shared_from_this(), next](error_code fault, std::size_t count) {
      (self.get()->*next)(fault, count);
    };
  }

  void receive() {
    if (gone_ || receives_ || !unread_.empty()) return;
    receives_ = true;
    stream_.async_read_some(boost::asio::buffer(part_), then(&WebStream::received));
  }

  void received(error_code fault, std::size_t count) {
    receives_ = false;
    if (fault) return hang_up();
    if (!ended_) unread_ = std::span{part_}.first(count);
    receive();
  }

  /// Sends the oldest message, or closes the stream after the last one.
  void send() {
    if (gone_ || sends_) return;
    if (messages_.empty() && !ended_) return;
    sends_ = true;
    if (messages_.empty()) {
      return stream_.async_close(websocket::close_code::try_again_later,
                                 [self = shared_from_this()](error_code) { self->hang_up(); });
    }
    stream_.text(is_ascii(messages_.front()));
    stream_.async_write(boost::asio::buffer(messages_.front()), then(&WebStream::sent));
  }

  void sent(error_code fault, std::size_t) {
    sends_ = false;
    sent_ = true;
    if (fault) return hang_up();
    unsent_ -= messages_.front().size();
    messages_.pop_front();
    send();
  }

  void hang_up() {
    gone_ = true;
    error_code ignored;
    stream_.next_layer().close(ignored);
  }

  Stream stream_;
  std::array<char, kStreamPart> part_{};  ///< Payload that was received last.
  std::span<const char> unread_;          ///< Rest of part_ that the reader has not taken.
  std::deque<std::string> messages_;      ///< Unsent messages; the oldest may be sent in part.
  std::size_t unsent_ = 0;                ///< Number of bytes in messages_.
  Clock::time_point until_;
  bool receives_ = false;
  bool sends_ = false;
  bool sent_ = false;   ///< Whether a message was sent since the last call of attend().
  bool parts_ = false;  ///< Whether the stream was closing when attend() was last called.
  bool left_ = false;   ///< Whether the client's close frame has arrived.
  bool ended_ = false;
  bool gone_ = false;
};

}  // namespace

std::shared_ptr<WebSocket> open_web_socket(
    boost::asio::ip::tcp::socket socket,
    const boost::beast::http::request<boost::beast::http::string_body>& request) {
  auto stream = std::make_shared<WebStream>(std::move(socket));
  return stream->accept(request) ? stream : nullptr;
}

}  // namespace sim
