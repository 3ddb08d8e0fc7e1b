#include "host-sim/serve/pty_transport.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <termios.h>

#include <array>
#include <filesystem>
#include <stdexcept>

#include "tests/host-sim/trace/scratch_file.hpp"

namespace sim {
namespace {

using hal::host::Descriptor;

namespace fs = std::filesystem;

Descriptor open_port(const std::string& path) {
  return Descriptor{::open(path.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK)};
}

std::string read_port(const Descriptor& port) {
  std::array<char, 200> text{};
  const ssize_t count = ::read(port.number(), text.data(), text.size());
  return {text.data(), count > 0 ? static_cast<std::size_t>(count) : 0};
}

std::string read_all(Connection& connection) {
  std::array<std::byte, 200> part{};
  const std::size_t count = connection.read(part);
  return {reinterpret_cast<const char*>(part.data()), count};
}

void write_all(Connection& connection, std::string_view text) {
  ASSERT_EQ(connection.write(std::as_bytes(std::span{text})), text.size());
}

TEST(PtyTransport, IsRawBeforeAnybodyOpensIt) {
  const ScratchFile link{".tty"};
  const PtyTransport pty{link.path()};
  const Descriptor port = open_port(link.path());
  ASSERT_GE(port.number(), 0);
  termios mode{};
  ASSERT_EQ(::tcgetattr(port.number(), &mode), 0);
  EXPECT_EQ(mode.c_lflag & static_cast<tcflag_t>(ECHO | ICANON | ISIG), 0U);
  EXPECT_EQ(mode.c_iflag & static_cast<tcflag_t>(ICRNL | IXON), 0U);
  EXPECT_EQ(mode.c_oflag & static_cast<tcflag_t>(OPOST), 0U);
}

TEST(PtyTransport, NoticesOpeningAndClosing) {
  const ScratchFile link{".tty"};
  PtyTransport pty{link.path()};
  EXPECT_EQ(pty.accept(), nullptr);
  for (int round = 0; round < 3; ++round) {
    Descriptor port = open_port(link.path());
    const auto sender = pty.accept();
    ASSERT_NE(sender, nullptr);
    EXPECT_EQ(pty.accept(), nullptr) << "only once";
    EXPECT_TRUE(sender->open());
    port = Descriptor{};
    EXPECT_FALSE(sender->open());
  }
}

TEST(PtyTransport, CarriesEveryByteUnchanged) {
  const ScratchFile link{".tty"};
  PtyTransport pty{link.path()};
  const Descriptor port = open_port(link.path());
  const auto sender = pty.accept();
  ASSERT_NE(sender, nullptr);
  std::string all;
  for (int byte = 0; byte < 200; ++byte) all += static_cast<char>(byte);
  write_all(*sender, all);
  EXPECT_EQ(read_port(port), all);
  ASSERT_EQ(::write(port.number(), all.data(), all.size()), static_cast<ssize_t>(all.size()));
  EXPECT_EQ(read_all(*sender), all);
}

TEST(PtyTransport, HearsWhatWasSentJustBeforeClosing) {
  const ScratchFile link{".tty"};
  PtyTransport pty{link.path()};
  {
    const Descriptor port = open_port(link.path());
    ASSERT_EQ(::write(port.number(), "?", 1), 1);
  }
  const auto sender = pty.accept();
  ASSERT_NE(sender, nullptr);
  EXPECT_TRUE(sender->open());
  EXPECT_EQ(read_all(*sender), "?");
  EXPECT_FALSE(sender->open());
}

TEST(PtyTransport, KeepsNothingOfOneSenderForTheNext) {
  const ScratchFile link{".tty"};
  PtyTransport pty{link.path()};
  Descriptor port = open_port(link.path());
  auto sender = pty.accept();
  ASSERT_NE(sender, nullptr);
  write_all(*sender, "unread");
  port = Descriptor{};
  sender.reset();
  const Descriptor next = open_port(link.path());
  EXPECT_EQ(read_port(next), "");
}

TEST(PtyTransport, HangsUpOnASenderWhoStays) {
  const ScratchFile link{".tty"};
  PtyTransport pty{link.path()};
  const fs::path device = fs::read_symlink(link.path());
  const Descriptor port = open_port(link.path());
  auto sender = pty.accept();
  ASSERT_NE(sender, nullptr);
  sender.reset();
  char byte = 0;
  EXPECT_NE(::read(port.number(), &byte, 1), 1);
  EXPECT_NE(errno, EAGAIN) << "the port is gone, not only quiet";
  EXPECT_NE(fs::read_symlink(link.path()), device);
  EXPECT_EQ(pty.accept(), nullptr);
}

TEST(PtyTransport, RemovesItsLinkAndOnlyItsOwn) {
  const ScratchFile link{".tty"};
  { const PtyTransport pty{link.path()}; }
  EXPECT_FALSE(fs::is_symlink(link.path()));
  {
    const PtyTransport first{link.path()};
    fs::remove(link.path());
    fs::create_symlink("/dev/pts/ptmx", link.path());
  }
  EXPECT_TRUE(fs::is_symlink(link.path())) << "somebody else's by now";
  fs::remove(link.path());
}

TEST(PtyTransport, LeavesTheLinkOfAServerThatRuns) {
  const ScratchFile link{".tty"};
  PtyTransport first{link.path()};
  const fs::path device = fs::read_symlink(link.path());
  try {
    const PtyTransport second{link.path()};
    FAIL() << "took the link away";
  } catch (const std::invalid_argument& refused) {
    EXPECT_NE(std::string{refused.what()}.find(device.string()), std::string::npos);
  }
  EXPECT_EQ(fs::read_symlink(link.path()), device);
  const Descriptor port = open_port(link.path());
  EXPECT_NE(first.accept(), nullptr) << "and the first is heard as before";
}

/// The kernel assigns the least free number, so that the link of a server that was killed may point
/// to the same pty that its successor receives.
TEST(PtyTransport, TakesOverTheLinkOfAServerThatWasKilled) {
  const ScratchFile link{".tty"};
  const PtyMaster master;
  fs::create_symlink(master.device(), link.path());
  PtyLink kept{link.path()};
  kept.point_to(master.device());
  EXPECT_EQ(fs::read_symlink(link.path()), master.device());
}

TEST(PtyTransport, ReplacesALinkThatAnotherRunLeftButNoFile) {
  const ScratchFile link{".tty"};
  fs::create_symlink("/dev/pts/987654", link.path());
  { const PtyTransport pty{link.path()}; }
  link.write("precious");
  EXPECT_THROW(PtyTransport{link.path()}, std::invalid_argument);
  EXPECT_EQ(link.text(), "precious");
}

}  // namespace
}  // namespace sim
