#include "host-sim/serve/http_request.hpp"

#include <gtest/gtest.h>

namespace sim {
namespace {

TEST(HttpRequest, ReadsAHead) {
  const auto request = parse_http_head(
      "POST /job?name=a%20b%C3%BC.nc&x HTTP/1.1\r\nHOST:  localhost:8000 \r\n"
      "Connection: keep-alive, Upgrade\r\nContent-Length: 12");
  ASSERT_TRUE(request);
  EXPECT_EQ(request->method, "POST");
  EXPECT_EQ(request->path, "/job");
  EXPECT_EQ(request->query.at("name"), "a b\xC3\xBC.nc");
  EXPECT_EQ(request->header("host"), "localhost:8000");
  EXPECT_TRUE(request->lists("connection", "upgrade"));
  EXPECT_FALSE(request->lists("connection", "close"));
  EXPECT_EQ(request->content_length(), 12U);
}

TEST(HttpRequest, RefusesWhatTwoReadersCouldTakeDifferently) {
  for (const char* head : {"",
                           "GET",
                           "GET / HTTP/2",
                           "GET  / HTTP/1.1",
                           "GET x HTTP/1.1",
                           "GET /%4 HTTP/1.1",
                           "GET / HTTP/1.1\r\nHost",
                           "GET / HTTP/1.1\r\nHost : a",
                           "GET / HTTP/1.1\r\nHost: a\r\nhost: b",
                           "GET / HTTP/1.1\r\nHost: a\r\n b",
                           "GET / HTTP/1.1\r\nHost: a\nOrigin: b",
                           "GET / HTTP/1.1\r\n: a"}) {
    EXPECT_FALSE(parse_http_head(head)) << head;
  }
}

TEST(HttpRequest, HasNoLengthWhereThatIsNoNumber) {
  for (const char* length : {"", "-1", "+1", "1 ", "0x10", "99999999999999999999999"}) {
    HttpRequest request;
    request.headers["content-length"] = length;
    EXPECT_FALSE(request.content_length()) << length;
  }
}

}  // namespace
}  // namespace sim
