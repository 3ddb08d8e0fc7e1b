#include "host-sim/send/wait_watch.hpp"

#include <gtest/gtest.h>

namespace sim {
namespace {

using std::chrono::milliseconds;

TEST(WaitWatch, SaysOnceForWhatTheMachineWaits) {
  WaitWatch watch;
  EXPECT_EQ(watch.attend("Run", 3, milliseconds{0}), "");
  EXPECT_EQ(watch.attend("Hold:1", 4, milliseconds{100}), "") << "it may only slow down";
  EXPECT_EQ(watch.attend("Hold:0", 4, milliseconds{900}), "");
  const std::string words = watch.attend("Hold:0", 4, milliseconds{1100});
  EXPECT_NE(words.find("before line 4: held"), std::string::npos) << words;
  EXPECT_EQ(watch.attend("Hold:0", 4, milliseconds{9000}), "");
}

TEST(WaitWatch, SaysItAgainTheNextTime) {
  WaitWatch watch;
  EXPECT_EQ(watch.attend("Tool", 0, milliseconds{0}), "");
  EXPECT_NE(watch.attend("Tool", 0, milliseconds{1000}).find("M6"), std::string::npos);
  EXPECT_EQ(watch.attend("Door:0", 0, milliseconds{1100}), "");
  EXPECT_NE(watch.attend("Door:0", 0, milliseconds{2200}).find("door"), std::string::npos);
  EXPECT_EQ(watch.attend("Run", 0, milliseconds{2300}), "");
  EXPECT_EQ(watch.attend("Tool", 0, milliseconds{2400}), "");
  EXPECT_NE(watch.attend("Tool", 0, milliseconds{3500}), "");
}

}  // namespace
}  // namespace sim
