/// libFuzzer: random bytes from browsers and senders, over several connections, through the web
/// server of `kerfline serve` to a controller in virtual time.
///
/// Bytes go to one of four connections; `@` among them stands for the server's address. 0xFE and
/// the byte after it are a command. Its low two bits choose the connection from there on, which is
/// opened if it does not exist. The next three bits choose another event (Bench::choose), and the
/// others the time that passes. 0xFF and the byte after it stand for a phrase of kPhrases.
///
/// Whatever arrives, nothing may crash, hang or leak. Each connection must receive an HTTP answer
/// of the announced length, or complete frames of a WebSocket and nothing after its close. When all
/// clients have left, no descriptor may remain open, the beam must be off, and the machine must
/// come to rest.

#include <sys/socket.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "hal/host/descriptor.hpp"
#include "hal/host/memory_store.hpp"
#include "host-sim/serve/live_view.hpp"
#include "host-sim/serve/reception.hpp"
#include "host-sim/serve/session.hpp"
#include "host-sim/serve/web_routes.hpp"
#include "host-sim/serve/web_transport.hpp"

namespace {

using std::chrono::milliseconds;

void require(bool holds, const char* what) {
  if (holds) return;
  std::fprintf(stderr, "violated: %s\n", what);
  std::abort();
}

template <std::size_t Size>
constexpr std::string_view bytes(const char (&text)[Size]) {
  return {text, Size - 1};
}

// clang-format off
constexpr std::array kPhrases = std::to_array<std::string_view>({
    // HTTP heads.
    "GET / HTTP/1.1\r\n", "HEAD /app.js HTTP/1.1\r\n", "GET /job HTTP/1.1\r\n",
    "GET /picture.svg HTTP/1.0\r\n", "POST /outline HTTP/1.1\r\n",
    "POST /job?name=a%20b.nc HTTP/1.1\r\n", "POST /job/run HTTP/1.1\r\n",
    "POST /job/resume HTTP/1.1\r\n", "POST /job/stop HTTP/1.1\r\n", "GET /observe HTTP/1.1\r\n",
    "GET /operate HTTP/1.1\r\n", "Host: @\r\n", "Origin: http://@\r\n", "Content-Length: 0\r\n",
    "Content-Length: 44\r\n", "Content-Length: 67108864\r\n", "Transfer-Encoding: chunked\r\n",
    "Expect: 100-continue\r\n", "Connection: keep-alive\r\n", "\r\n",
    "Upgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Version: 13\r\n"
    "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n",
    // WebSocket frames.
    bytes("\x81\x81\0\0\0\0?"), bytes("\x81\x81\0\0\0\0!"), bytes("\x81\x81\0\0\0\0~"),
    bytes("\x81\x81\0\0\0\0\x18"), bytes("\x82\x81\0\0\0\0\x84"), bytes("\x88\x80\0\0\0\0"),
    bytes("\x88\x82\0\0\0\0\x03\xe8"), bytes("\x89\x81\0\0\0\0p"), bytes("\x8a\x80\0\0\0\0"),
    bytes("\x01\x80\0\0\0\0"), bytes("\x80\x80\0\0\0\0"), bytes("\x82\x8e\0\0\0\0M3S900G1X9F99\n"),
    bytes("\x81\x83\0\0\0\0$X\n"), bytes("\x81\x83\0\0\0\0$$\n"), bytes("\x82\xfe\x01\0\0\0\0\0"),
    bytes("\x82\xff\0\0\0\0\0\x01\0\0\0\0\0\0"),
    // Programs, and the list of faults that an operator accepts.
    "G91 M3 S500 F9000\nG1 X9\nG1 X-9\nM5\nG4 P0.1\n", "G7\n", "[\"line 1: \"]", "2c\r\n",
    "0\r\n\r\n",
});
// clang-format on

/// Checks all that the server sends on one connection.
class AnswerJudge {
 public:
  void take(std::string_view part) {
    heard_ += part;
    if (!begun_ && !take_head()) return;
    if (!frames_) {
      require(heard_.size() <= length_, "no more than the length that was announced");
      return;
    }
    while (take_frame()) {
    }
  }

 private:
  bool take_head() {
    const std::size_t end = heard_.find("\r\n\r\n");
    if (end == std::string::npos) return false;
    begun_ = true;
    require(heard_.starts_with("HTTP/1.1 ") && heard_[12] == ' ', "an answer of HTTP");
    frames_ = heard_.compare(9, 3, "101") == 0;
    constexpr std::string_view kLength = "\r\nContent-Length: ";
    const std::size_t length = heard_.find(kLength);
    require(frames_ || length < end, "an answer has a length");
    if (!frames_) length_ = std::strtoul(heard_.c_str() + length + kLength.size(), nullptr, 10);
    heard_.erase(0, end + 4);
    return true;
  }

  [[nodiscard]] unsigned byte(std::size_t at) const {
    return static_cast<unsigned char>(heard_[at]);
  }

  bool take_frame() {
    if (heard_.empty()) return false;
    require(!closed_, "nothing behind a close frame");
    if (heard_.size() < 2) return false;
    const unsigned opcode = byte(0) ^ 0x80U;  // Each frame must be final and have no RSV bit.
    require(opcode == 1 || opcode == 2 || opcode == 8 || opcode == 10, "a frame of a server's");
    require(byte(1) < 0x80, "no mask");
    const std::size_t wide = byte(1) == 126 ? 2 : byte(1) == 127 ? 8 : 0;
    if (heard_.size() < 2 + wide) return false;
    std::size_t length = wide == 0 ? byte(1) : 0;
    for (std::size_t at = 0; at < wide; ++at) length = length << 8U | byte(2 + at);
    require(length <= sim::WebSocket::kMaxUnsent, "a frame of some size");
    if (heard_.size() < 2 + wide + length) return false;
    const std::string payload = heard_.substr(2 + wide, length);
    heard_.erase(0, 2 + wide + length);
    require(opcode != 1 || std::none_of(payload.begin(),
                                        payload.end(),
                                        [](char c) { return static_cast<signed char>(c) < 0; }),
            "text is ASCII");
    closed_ = opcode == 8;
    return true;
  }

  std::string heard_;
  std::size_t length_ = 0;
  bool begun_ = false;
  bool frames_ = false;
  bool closed_ = false;
};

/// The server of `kerfline serve --ws` with the clients' ends of its connections.
class Bench {
 public:
  Bench() {
    auto web = std::make_unique<sim::WebTransport>(
        sim::InternetAddress{}, routes_, [this] { return now_; });
    web_ = web.get();
    reception_.set_job(job_);
    reception_.add(std::move(web));
    session_.controller().add_sink(view_);
  }

  void choose(std::uint8_t choice) {
    chosen_ = choice & 3U;
    switch ((choice >> 2U) & 7U) {
      case 1:
        clients_[chosen_].reset();
        break;
      case 2:
        if (clients_[chosen_]) ::shutdown(clients_[chosen_]->link.number(), SHUT_WR);
        break;
      case 3:
        reads_ = !reads_;
        break;
      case 4:
        now_ += std::chrono::seconds{11};
        break;
      default:
        break;
    }
    turns(1U << (choice >> 5U));
  }

  void send(std::string_view part) {
    for (const char byte : part) {
      if (byte == '@') {
        pending_ += web_->address();
      } else {
        pending_ += byte;
      }
    }
  }

  /// Writes the pending bytes to the chosen connection; drops bytes for which it has no space.
  void flush() {
    if (pending_.empty()) return;
    const std::string part = std::exchange(pending_, {});
    auto& client = clients_[chosen_];
    if (!client) connect(client);
    std::string_view rest = part;
    for (int tries = 0; !rest.empty() && tries < 3; ++tries) {
      const ssize_t count =
          ::send(client->link.number(), rest.data(), rest.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
      if (count > 0) rest.remove_prefix(static_cast<std::size_t>(count));
      turn();
    }
  }

  void turns(unsigned count) {
    flush();
    for (; count > 0; --count) turn();
  }

  void end() {
    flush();
    reads_ = true;
    for (int count = 0; count < 3; ++count, turn()) ::usleep(100);
    for (auto& client : clients_) client.reset();
    for (int count = 0; count < kTurnsToRest && !rests(); ++count) turn();
    require(rests(), "the machine comes to rest");
    require(session_.controller().port().power == 0, "the beam is off");
    // Other threads of the server work in real time, so that this waits by the clock.
    for (int count = 0; count < 5000 && descriptors() > 1; ++count, turn()) ::usleep(1000);
    require(descriptors() == 1, "no descriptor is kept but the listener's");
  }

 private:
  struct Client {
    hal::host::Descriptor link;
    AnswerJudge judge;
  };
  static constexpr int kTurnsToRest = 20'000;

  void connect(std::optional<Client>& client) {
    std::array<int, 2> ends{};
    require(::socketpair(AF_UNIX, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0, ends.data()) == 0,
            "a pair of sockets");
    client.emplace(Client{.link = hal::host::Descriptor{ends[0]}, .judge = {}});
    web_->meet(hal::host::Descriptor{ends[1]});
  }

  void turn() {
    session_.turn();
    now_ += milliseconds{1};
    reception_.attend(now_);
    if (view_.due(now_)) view_.publish(web_->watchers(), reception_.sender_kind(), now_);
    if (!reads_) return;
    for (auto& client : clients_) {
      if (client) hear(*client);
    }
  }

  void hear(Client& client) {
    for (;;) {
      const ssize_t count = ::recv(client.link.number(), part_.data(), part_.size(), MSG_DONTWAIT);
      if (count <= 0) return;
      client.judge.take({part_.data(), static_cast<std::size_t>(count)});
    }
  }

  [[nodiscard]] std::size_t descriptors() const {
    std::vector<pollfd> all;
    web_->add_to(all);
    return all.size();
  }

  /// Returns whether the machine rests. A job continues after all clients have left, so an operator
  /// at the machine stops it.
  [[nodiscard]] bool rests() {
    if (job_.running()) job_.stop();
    return !job_.running() && reception_.sender_kind().empty() && session_.calm() &&
           session_.controller().port().power == 0;
  }

  hal::host::MemoryStore store_;
  sim::Session session_{sim::MachineModel{},
                        {{.number = cnc::setting::kLaserMode, .value = 1.0F, .place = "bench"}},
                        store_};
  sim::ServedJob job_;
  sim::LiveView view_{session_.controller(), job_};
  sim::Reception reception_{session_};
  sim::WebRoutes routes_{session_.controller(), view_, reception_, job_};
  sim::WebTransport* web_ = nullptr;
  sim::Reception::Clock::time_point now_{std::chrono::hours{1}};
  std::array<std::optional<Client>, 4> clients_;
  std::array<char, 65536> part_{};
  std::string pending_;  ///< Bytes for the chosen client that are not written yet.
  unsigned chosen_ = 0;
  bool reads_ = true;
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr std::uint8_t kChoice = 0xFE;
  constexpr std::uint8_t kPhrase = 0xFF;
  Bench bench;
  for (std::size_t at = 0; at < size; ++at) {
    if ((data[at] != kChoice && data[at] != kPhrase) || at + 1 == size) {
      const char byte = static_cast<char>(data[at]);
      bench.send({&byte, 1});
    } else if (data[at] == kPhrase) {
      bench.send(kPhrases[data[++at] % kPhrases.size()]);
    } else {
      bench.turns(1);
      bench.choose(data[++at]);
    }
  }
  bench.end();
  return 0;
}
