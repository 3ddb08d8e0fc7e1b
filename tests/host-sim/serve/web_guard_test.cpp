#include "host-sim/serve/web_guard.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace sim {
namespace {

const InternetAddress kHere{"127.0.0.1", 8000};
const InternetAddress kEverywhere{"0.0.0.0", 8000};

TEST(WebGuard, ServesTheNamesOfThisMachine) {
  for (const char* host : {"127.0.0.1:8000", "localhost:8000", "127.0.1.1:8000"}) {
    EXPECT_TRUE(is_our_host(host, kHere)) << host;
  }
}

TEST(WebGuard, RefusesForeignNamesAndPorts) {
  for (const char* host : {"",
                           "evil.example:8000",
                           "localhost",
                           "localhost:80",
                           "localhost:18000",
                           "127.0.0.1.evil.example:8000",
                           "evil.example#localhost:8000",
                           "192.168.1.7:8000"}) {
    EXPECT_FALSE(is_our_host(host, kHere)) << host;
  }
}

TEST(WebGuard, ServesNumbersWhereItListensBeyondThisMachine) {
  EXPECT_TRUE(is_our_host("192.168.1.7:8000", kEverywhere));
  EXPECT_FALSE(is_our_host("evil.example:8000", kEverywhere));
}

TEST(WebGuard, KnowsThatPort80IsNotWritten) {
  EXPECT_TRUE(is_our_host("localhost", {"127.0.0.1", 80}));
}

TEST(WebGuard, KnowsNamesInAnyCase) {
  EXPECT_TRUE(is_our_host("LocalHost:8000", kHere));
  EXPECT_TRUE(is_same_origin("HTTP://localhost:8000", "LOCALHOST:8000"));
}

TEST(WebGuard, TakesRequestsOfTheVeryPageThatItServesAndOfNoPage) {
  EXPECT_TRUE(is_same_origin("", "localhost:8000"));
  EXPECT_TRUE(is_same_origin("http://localhost:8000", "localhost:8000"));
  for (const char* origin : {"https://evil.example",
                             "http://localhost:9000",
                             "http://127.0.0.1:8000",
                             "http://192.168.1.9:8000",
                             "https://localhost:8000",
                             "http://localhost:8000/",
                             "null"}) {
    EXPECT_FALSE(is_same_origin(origin, "localhost:8000")) << origin;
  }
}

TEST(InternetAddress, IsThisMachineUnlessItIsSaid) {
  EXPECT_EQ(to_string(parse_address("2323")), "127.0.0.1:2323");
  EXPECT_EQ(to_string(parse_address("localhost:0")), "127.0.0.1:0");
  EXPECT_EQ(to_string(parse_address("0.0.0.0:80")), "0.0.0.0:80");
}

TEST(InternetAddress, RefusesWhatIsNone) {
  for (const char* text :
       {"", "x", ":80", "70000", "-1", "80x", "name:80", "1.2.3:80", "1.2.3.4:"}) {
    EXPECT_THROW(static_cast<void>(parse_address(text)), std::invalid_argument) << text;
  }
}

}  // namespace
}  // namespace sim
