#include "hal/host/socket_can.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <stdexcept>
#include <string>

namespace hal::host {
namespace {

constexpr std::array<std::uint32_t, 3> kHeard{0x000, 0x123, 0x7FF};
constexpr std::array<std::uint32_t, 1> kNothing{0x001};

TEST(SocketCanInterface, IsNamedWithWhatIsWrongWithIt) {
  for (const std::string name : {"nosuchcan0", "", "a-name-longer-than-any-interface-has"}) {
    try {
      const SocketCan port{name, kHeard};
      FAIL() << name;
    } catch (const std::runtime_error& error) {
      EXPECT_EQ(std::string{error.what()}.find("can " + name + ": "), 0U) << error.what();
    }
  }
}

/// Two nodes on a bus of the kernel, whose name is in KERFLINE_CAN. CTest runs these tests only in
/// tests/host-sim/can, which provides such a bus.
class SocketCanTest : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_FALSE(interface().empty()) << "KERFLINE_CAN names no CAN interface";
  }
  static std::string interface() {
    const char* const name = std::getenv("KERFLINE_CAN");
    return name != nullptr ? name : "";
  }
  static CanFrame frame(std::uint32_t id) {
    return {.id = id, .length = 3, .data = {std::byte{1}, std::byte{2}, std::byte{0xFF}}};
  }
};

TEST_F(SocketCanTest, PassesFramesInTheirOrder) {
  SocketCan one{interface(), kNothing};
  SocketCan other{interface(), kHeard};
  for (const std::uint32_t id : kHeard) ASSERT_TRUE(one.send(frame(id)));
  CanFrame found;
  for (const std::uint32_t id : kHeard) {
    ASSERT_TRUE(other.receive(found));
    EXPECT_EQ(found, frame(id));
  }
  EXPECT_FALSE(other.receive(found));
  EXPECT_FALSE(one.receive(found)) << "its own";
  EXPECT_EQ(one.room(), SocketCan::kFrames);
  EXPECT_TRUE(one.up());
}

TEST_F(SocketCanTest, HearsNothingButWhatItIsTo) {
  SocketCan one{interface(), kNothing};
  SocketCan other{interface(), kHeard};
  CanFrame extended = frame(0x123);
  extended.extended = true;
  CanFrame remote{.id = 0x123, .remote = true};
  for (const CanFrame& each : {frame(0x122), extended, remote, frame(0x124), frame(0x123)}) {
    ASSERT_TRUE(one.send(each));
  }
  CanFrame found;
  ASSERT_TRUE(other.receive(found));
  EXPECT_EQ(found, frame(0x123));
  EXPECT_FALSE(other.receive(found));
}

/// A node that does not read for long learns that frames were lost, and how many.
TEST_F(SocketCanTest, CountsFramesThatTheKernelDropped) {
  constexpr std::uint32_t kFrames = 20'000;
  SocketCan one{interface(), kNothing};
  SocketCan other{interface(), kHeard};
  for (std::uint32_t n = 0; n < kFrames; ++n) ASSERT_TRUE(one.send(frame(0x123)));
  std::uint32_t heard = 0;
  for (CanFrame found; other.receive(found);) ++heard;
  ASSERT_LT(heard, kFrames);
  // The kernel reports the loss with the next frame for which it has space.
  ASSERT_TRUE(one.send(frame(0x123)));
  CanFrame found;
  ASSERT_TRUE(other.receive(found));
  EXPECT_EQ(heard + other.health().lost_frames, kFrames);
}

}  // namespace
}  // namespace hal::host
