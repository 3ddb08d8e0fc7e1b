#include <gtest/gtest.h>

#include "tests/host-sim/serve/web_bench.hpp"

namespace sim {
namespace {

using std::chrono::seconds;

TEST(WebHttp, ReadsARequest) {
  WebBench bench;
  const std::string answer = bench.answer_to(
      "POST /job?name=a%20b%C3%BC.nc&x HTTP/1.1\r\nHOST:  {} \r\n"
      "Connection: keep-alive, Upgrade\r\nContent-Length: 12\r\n\r\nG0 X1\nG0 X2\nmore");
  EXPECT_TRUE(answer.starts_with("HTTP/1.1 200 OK\r\n")) << answer;
  EXPECT_TRUE(answer.ends_with("\r\n\r\nfine")) << answer;
  const HttpRequest& request = bench.service.last;
  EXPECT_EQ(request.method, "POST");
  EXPECT_EQ(request.path, "/job");
  EXPECT_EQ(request.query.at("name"), "a b\xC3\xBC.nc");
  EXPECT_EQ(request.query.at("x"), "");
  EXPECT_EQ(request.host, bench.transport.address());
  EXPECT_EQ(request.length, 12U);
  EXPECT_FALSE(request.wants_web_socket);
  EXPECT_EQ(request.body, "G0 X1\nG0 X2\n");
}

TEST(WebHttp, ReadsARequestWhateverComesAtOnce) {
  WebBench bench;
  WebBench::Client client = bench.connect();
  bench.send(client, "POST / HTTP/1.1\r\nHost: {}");
  for (const char byte : std::string_view{"\r\nContent-Length: 3\r\n\r\nabc"}) {
    bench.send(client, std::string{byte});
    bench.turn();
  }
  EXPECT_TRUE(bench.sees_it_close(client));
  EXPECT_EQ(bench.service.last.body, "abc");
}

TEST(WebHttp, RefusesWhatTwoReadersCouldTakeDifferently) {
  WebBench bench;
  const std::string host = "Host: {}\r\n";
  const std::string post = "POST / HTTP/1.1\r\n" + host;
  for (const std::string& head : {std::string{"GET"},
                                  std::string{"GET /"},
                                  "GET / HTTP/2\r\n" + host,
                                  "GET / HTTP/2.0\r\n" + host,
                                  "GET / http/1.1\r\n" + host,
                                  "GET  / HTTP/1.1\r\n" + host,
                                  "G[T / HTTP/1.1\r\n" + host,
                                  "GET x HTTP/1.1\r\n" + host,
                                  "GET http://x/ HTTP/1.1\r\n" + host,
                                  "GET /%4 HTTP/1.1\r\n" + host,
                                  "GET /%zz HTTP/1.1\r\n" + host,
                                  "GET /?a=%4 HTTP/1.1\r\n" + host,
                                  "GET / HTTP/1.1\r\n" + host + "Host",
                                  "GET / HTTP/1.1\r\n" + host + "X : a",
                                  "GET / HTTP/1.1\r\n" + host + "host: b",
                                  "GET / HTTP/1.1\r\n" + host + "X: a\r\nx: a",
                                  "GET / HTTP/1.1\r\n" + host + "X: a\nOrigin: b",
                                  "GET / HTTP/1.1\r\n" + host + "X: \x01",
                                  "GET / HTTP/1.1\r\n" + host + std::string{"X: \0", 4},
                                  "GET / HTTP/1.1\r\n" + host + ": a",
                                  post + "Content-Length: 1\r\nContent-Length: 2",
                                  post + "Content-Length: 1\r\nContent-Length: 1",
                                  post + "Content-Length: 1\r\nTransfer-Encoding: chunked",
                                  post + "Content-Length:",
                                  post + "Content-Length: -1",
                                  post + "Content-Length: +1",
                                  post + "Content-Length: 0x10",
                                  post + "Content-Length: 1 1",
                                  post + "Content-Length: 99999999999999999999999"}) {
    const std::string answer = bench.answer_to(head + "\r\n\r\n");
    EXPECT_TRUE(answer.starts_with("HTTP/1.1 400 Bad Request\r\n")) << head << '\n' << answer;
  }
  EXPECT_TRUE(
      bench.answer_to("GET / HTTP/1.1\r\nHost: {}\r\n b\r\n\r\n").starts_with("HTTP/1.1 403"))
      << "a header that goes on in the next line";
  EXPECT_TRUE(bench.service.last.method.empty()) << "none of them is answered";
}

TEST(WebHttp, HasNoLengthWhereNoneIsAnnounced) {
  WebBench bench;
  for (const char* coding : {"", "Transfer-Encoding: gzip\r\nContent-Length: 1\r\n"}) {
    bench.answer_to(std::string{"POST / HTTP/1.1\r\nHost: {}\r\n"} + coding + "\r\nx");
    EXPECT_EQ(bench.service.last.method, "POST");
    EXPECT_FALSE(bench.service.last.length) << coding;
  }
  bench.answer_to(
      "POST / HTTP/1.1\r\nHost: {}\r\nTransfer-Encoding: chunked\r\n\r\n1\r\nx\r\n0\r\n\r\n");
  EXPECT_FALSE(bench.service.last.length);
}

TEST(WebHttp, ReadsNeitherALongHeadNorALongBody) {
  WebBench bench;
  EXPECT_TRUE(bench.answer_to("GET / HTTP/1.1\r\nX: " + std::string(17 << 10, 'x'))
                  .starts_with("HTTP/1.1 431"));
  EXPECT_TRUE(bench.answer_to("GET /" + std::string(17 << 10, 'x')).starts_with("HTTP/1.1 431"));
  for (const char* method : {"GET", "POST"}) {
    const std::string head = std::string{method} + " / HTTP/1.1\r\nHost: {}\r\n";
    EXPECT_TRUE(
        bench.answer_to(head + "Content-Length: 67108865\r\n\r\n").starts_with("HTTP/1.1 413"));
    EXPECT_TRUE(bench.answer_to(head + "Transfer-Encoding: chunked\r\n\r\n4000001\r\n")
                    .starts_with("HTTP/1.1 413"));
  }
}

TEST(WebHttp, AnswersTheHeadAlone) {
  WebBench bench;
  bench.service.content = std::string(100'000, 'x');
  const std::string answer = bench.answer_to("HEAD / HTTP/1.1\r\nHost: {}\r\n\r\n");
  EXPECT_NE(answer.find("Content-Length: 100000\r\n"), std::string::npos) << answer;
  EXPECT_NE(answer.find("Connection: close\r\n"), std::string::npos) << answer;
  EXPECT_TRUE(answer.ends_with("\r\n\r\n")) << answer;
}

TEST(WebHttp, SendsLongAnswersWhole) {
  WebBench bench;
  bench.service.content = std::string(20 << 20, 'x') + "end";
  const std::string answer = bench.answer_to("GET / HTTP/1.1\r\nHost: {}\r\n\r\n");
  EXPECT_EQ(answer.size() - answer.find("\r\n\r\n") - 4, bench.service.content.size());
  EXPECT_TRUE(answer.ends_with("xend"));
}

TEST(WebHttp, HangsUpOnAClientThatAsksNothingInTime) {
  WebBench bench;
  WebBench::Client silent = bench.connect();
  WebBench::Client slow = bench.connect();
  bench.send(slow, "GET /");
  bench.turns();
  bench.pass(seconds{6});
  bench.send(slow, " HTTP/1.1\r\n");
  bench.turns();
  bench.hear(slow);
  EXPECT_FALSE(slow.closed) << "it has its time";
  bench.pass(seconds{6});
  EXPECT_TRUE(bench.sees_it_close(silent));
  EXPECT_TRUE(bench.sees_it_close(slow)) << "for all of the head";
  EXPECT_EQ(silent.heard + slow.heard, "");
}

TEST(WebHttp, TellsAClientWhoseBodyStops) {
  WebBench bench;
  WebBench::Client client = bench.connect();
  bench.send(client, "POST / HTTP/1.1\r\nHost: {}\r\nContent-Length: 5\r\n\r\n");
  for (const char* part : {"a", "b", "c"}) {
    bench.turns();
    bench.pass(seconds{9});
    bench.send(client, part);
  }
  bench.hear(client);
  EXPECT_EQ(client.heard, "") << "each part has its time";
  bench.pass(seconds{11});
  EXPECT_TRUE(bench.hears(client, "\r\n\r\nThe request did not arrive in time.")) << client.heard;
  EXPECT_TRUE(client.heard.starts_with("HTTP/1.1 408"));
}

TEST(WebHttp, HangsUpOnAClientThatDoesNotTakeItsAnswer) {
  WebBench bench;
  bench.service.content = std::string(20 << 20, 'x');
  WebBench::Client client = bench.connect();
  bench.send(client, "GET / HTTP/1.1\r\nHost: {}\r\n\r\n");
  bench.turns();
  EXPECT_TRUE(bench.hears(client, "\r\n\r\nx"));
  bench.turns();
  bench.pass(seconds{11});
  EXPECT_TRUE(bench.sees_it_close(client));
  EXPECT_LT(client.heard.size(), bench.service.content.size());
}

TEST(WebHttp, AConnectionMoreThanThereMayBeTakesThePlaceOfASilentOne) {
  WebBench bench;
  WebBench::Client first = bench.connect();
  bench.send(first, "GET");
  bench.turns();
  std::vector<WebBench::Client> others;
  while (others.size() < WebTransport::kMaxClients) others.push_back(bench.connect());
  bench.turns();
  EXPECT_TRUE(bench.sees_it_close(first));
  EXPECT_TRUE(bench.answer_to("GET / HTTP/1.1\r\nHost: {}\r\n\r\n").starts_with("HTTP/1.1 200"));
}

}  // namespace
}  // namespace sim
