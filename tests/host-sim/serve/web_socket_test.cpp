#include "host-sim/serve/web_socket.hpp"

#include <gtest/gtest.h>

#include "tests/host-sim/serve/client_frame.hpp"
#include "tests/host-sim/serve/web_bench.hpp"

namespace sim {
namespace {

using std::chrono::seconds;
using std::string_literals::operator""s;

std::size_t write(Connection& connection, std::string_view text) {
  return connection.write(std::as_bytes(std::span{text}));
}

TEST(WebSocketServer, AnswersTheHandshakeOfTheStandard) {
  WebBench bench;
  WebBench::Client client = bench.connect();
  bench.send(client, WebBench::handshake());
  EXPECT_TRUE(bench.hears(client, "\r\n\r\n"));
  EXPECT_TRUE(client.heard.starts_with("HTTP/1.1 101 Switching Protocols\r\n"));
  EXPECT_NE(client.heard.find("Sec-WebSocket-Accept: s3pPLMBiTxaQ9kYGzzhZRbK+xOo=\r\n"),
            std::string::npos)
      << client.heard;
}

TEST(WebSocketServer, RefusesHandshakesThatAreNone) {
  WebBench bench;
  const auto with = [](std::string_view words, std::string_view instead) {
    std::string text = WebBench::handshake();
    return text.replace(text.find(words), words.size(), instead);
  };
  for (const std::string& request : {with("GET", "POST"),
                                     with("Connection: Upgrade", "Connection: close"),
                                     with("Sec-WebSocket-Key", "X"),
                                     with("Sec-WebSocket-Version", "X"),
                                     with("Host: {}", "Content-Length: 5\r\nHost: {}"),
                                     WebBench::handshake() + client_frame(0x81, "early")}) {
    const std::string answer = bench.answer_to(request);
    EXPECT_EQ(answer.substr(8, 5), " 400 ") << request << answer;
  }
  const std::string answer = bench.answer_to(with("Version: 13", "Version: 8"));
  EXPECT_EQ(answer.substr(8, 5), " 426 ") << answer;
  EXPECT_NE(answer.find("Sec-WebSocket-Version: 13\r\n"), std::string::npos) << answer;
  EXPECT_TRUE(bench.senders.empty());
}

/// Found by a fuzzer: the answer to the handshake was one of HTTP 1.0.
TEST(WebSocketServer, AnswersAHandshakeOfHttp10AsIfItWereNone) {
  WebBench bench;
  std::string text = WebBench::handshake();
  text.replace(text.find("1.1"), 3, "1.0");
  EXPECT_TRUE(bench.answer_to(text).starts_with("HTTP/1.1 200 "));
}

TEST(WebSocketServer, ReadsTheExampleOfTheStandardWhateverComesAtOnce) {
  const std::string hello = client_frame(0x81, "Hello");
  EXPECT_EQ(hello, "\x81\x85\x37\xfa\x21\x3d\x7f\x9f\x4d\x51\x58"s);
  for (std::size_t at_once = 1; at_once <= hello.size(); at_once += 5) {
    WebBench bench;
    WebBench::Client client = bench.open_socket();
    const std::string both = hello + hello;
    for (std::size_t at = 0; at < both.size(); at += at_once) {
      bench.send(client, both.substr(at, at_once));
      bench.turn();
    }
    EXPECT_EQ(bench.sent(), "HelloHello") << at_once;
  }
}

TEST(WebSocketServer, JoinsFragmentsAndAnswersAPingBetweenThem) {
  WebBench bench;
  WebBench::Client client = bench.open_socket();
  bench.send(
      client,
      client_frame(0x01, "Hel") + client_frame(0x89, "are you there") + client_frame(0x80, "lo"));
  EXPECT_EQ(bench.sent(), "Hello");
  EXPECT_TRUE(bench.hears(client,
                          "\x8a\x0d"
                          "are you there"));
  EXPECT_TRUE(bench.senders.at(0)->open());
}

TEST(WebSocketServer, TakesAnyBytesInBinaryMessages) {
  WebBench bench;
  WebBench::Client client = bench.open_socket();
  std::string bytes;
  for (int byte = 0; byte < 256; ++byte) bytes += static_cast<char>(byte);
  bench.send(client, client_frame(0x82, bytes));
  EXPECT_EQ(bench.sent(), bytes);
}

TEST(WebSocketServer, ClosesWhenTheClientDoesOrBreaksTheRules) {
  const std::string fine = client_frame(0x81, "ok");
  struct Case {
    const char* name;
    std::string bytes;
    std::string close;  ///< Payload of the close frame.
  };
  const std::string fault = "\x03\xea";
  for (const Case& one : {
           Case{"the client closes", client_frame(0x88, ""), "\x03\xe8"},
           Case{"no mask", "\x81\x05Hello"s, fault},
           Case{"a mask, then none", fine + "\x82\x01!"s, fault},
           Case{"RSV1", client_frame(0xC1, "Hello"), fault},
           Case{"RSV2", client_frame(0xA1, "Hello"), fault},
           Case{"RSV3", client_frame(0x91, "Hello"), fault},
           Case{"RSV1 of a ping", client_frame(0xC9, ""), fault},
           Case{"opcode 3", client_frame(0x83, "Hello"), fault},
           Case{"opcode 11", client_frame(0x8B, ""), fault},
           Case{"goes on with nothing", client_frame(0x80, "Hello"), fault},
           Case{"begins within a message",
                client_frame(0x01, "Hel") + client_frame(0x81, "Hello"),
                fault},
           Case{"a ping in parts", client_frame(0x09, ""), fault},
           Case{"a long ping", "\x89\xfe\x01\x00\0\0\0\0"s, fault},
           Case{"a length in more bytes than it takes", "\x82\xfe\x00\x05\0\0\0\0Hello"s, fault},
           Case{"a close frame of one byte", client_frame(0x88, "x"), fault},
           Case{"text that is not UTF-8", client_frame(0x81, "Hello\xff"), "\x03\xef"},
           Case{"too large", "\x82\xff\0\0\0\0\x04\0\0\x01\0\0\0\0"s, "\x03\xf1"},
           Case{"huge", "\x82\xff\x7f\xff\xff\xff\xff\xff\xff\xff\0\0\0\0"s, "\x03\xf1"},
       }) {
    WebBench bench;
    WebBench::Client client = bench.open_socket();
    bench.send(client, one.bytes + fine);
    const std::string sent = bench.sent();
    EXPECT_EQ(sent.find("Hello"), std::string::npos) << one.name;
    EXPECT_EQ(sent.find("okok"), std::string::npos) << one.name;
    EXPECT_FALSE(bench.senders.at(0)->open()) << one.name << ": at once, not when its end comes";
    EXPECT_TRUE(bench.sees_it_close(client)) << one.name;
    EXPECT_EQ(client.heard, "\x88\x02" + one.close) << one.name;
  }
}

TEST(WebSocketServer, WritesEveryLengthAsItsReaderExpects) {
  WebBench bench;
  WebBench::Client client = bench.open_socket();
  bench.turns();
  Connection& sender = *bench.senders.at(0);
  EXPECT_EQ(write(sender, "Hello"), 5U);
  EXPECT_TRUE(bench.hears(client, "\x81\x05Hello"));
  client.heard.clear();
  EXPECT_EQ(write(sender, "\xB0" + std::string(255, 'x')), 256U);
  EXPECT_TRUE(bench.hears(client, "\x82\x7e\x01\x00\xB0xxx"s));
  client.heard.clear();
  EXPECT_EQ(write(sender, std::string(65'535, 'x') + "y"), 65'536U);
  EXPECT_TRUE(bench.hears(client, "y"));
  EXPECT_TRUE(
      client.heard.ends_with("\x81\x7f\0\0\0\0\0\x01\0\0"s + std::string(65'535, 'x') + "y"));
}

TEST(WebSocketServer, HangsUpOnAClientThatTakesNothing) {
  WebBench bench;
  WebBench::Client client = bench.open_socket();
  bench.turns();
  Connection& sender = *bench.senders.at(0);
  const std::string news(100'000, 'x');
  std::size_t taken = 0;
  for (int count = 0; count < 200; ++count, bench.turn()) taken += write(sender, news);
  EXPECT_LT(taken, 200 * news.size()) << "the rest waits with its writer";
  bench.pass(seconds{29});
  EXPECT_TRUE(sender.open());
  bench.pass(seconds{2});
  EXPECT_FALSE(sender.open());
}

TEST(WebSocketServer, WaitsOnlySoLongForAClientToClose) {
  WebBench bench;
  WebBench::Client client = bench.open_socket("/observe");
  bench.turns();
  const std::shared_ptr<WebSocket> watcher = bench.transport.watchers().at(0);
  watcher->end();
  EXPECT_TRUE(bench.hears(client, "\x88\x02\x03\xf5"));
  bench.pass(seconds{1});
  EXPECT_FALSE(watcher->gone());
  bench.pass(seconds{2});
  EXPECT_TRUE(watcher->gone());
}

TEST(WebSocketServer, HearsThatAClientIsGone) {
  WebBench bench;
  { const WebBench::Client client = bench.open_socket(); }
  bench.turns();
  EXPECT_FALSE(bench.senders.at(0)->open());
}

}  // namespace
}  // namespace sim
