#include "host-sim/job/program_digest.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "host-sim/job/text_hash.hpp"
#include "tests/support/random_source.hpp"
#include "tests/support/trials.hpp"

namespace sim {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

TEST(ProgramDigests, TheHashIsFnv1a) {
  // Test vectors from the authors of FNV.
  EXPECT_EQ(digest_of(""), "cbf29ce484222325");
  EXPECT_EQ(digest_of("a"), "af63dc4c8601ec8c");
  EXPECT_EQ(digest_of("foobar"), "85944171f73967e8");
  static_assert(text_hash("foobar") == text_hash("bar", text_hash("foo")));
}

TEST(ProgramDigests, AnyNameIsReadBackAsItWasWritten) {
  for (const std::uint64_t seed : proof::Trials{2000}) {
    proof::Random random{seed};
    ProgramDigest digest{"drawing", digest_of(std::to_string(seed)), {}};
    for (std::size_t i = 1 + random.below(20); i > 0; --i) {
      digest.name += static_cast<char>(1 + random.below(255));
    }
    const std::string line = "(" + text_of(digest) + ")\n";
    for (const char c : line)
      EXPECT_TRUE(c == '\n' || (c >= ' ' && c < '\x7f' && c != '!' && c != '?'));
    EXPECT_THAT(digests_in("(first)\n" + line + "G21\n"), ElementsAre(digest)) << line;
  }
}

TEST(ProgramDigests, OnlyTheTopOfAProgramHasThem) {
  const std::string line = "(kerfline digest drawing=0123456789abcdef a.svg)\n";
  EXPECT_EQ(digests_in("%\n; made\r\n\n  " + line + line + "G0X1\n" + line).size(), 2U);
  EXPECT_THAT(digests_in("G21\n" + line), IsEmpty());
  for (const char* bad : {"(kerfline digest drawing=0123456789abcde a.svg)",
                          "(kerfline digest drawing=0123456789abcdef)",
                          "(kerfline digest drawing=0123456789abcdef )",
                          "(kerfline digest drawing)",
                          "(kerfline digest drawing=0123456789ABCDEF a.svg)",
                          "(kerfline digest drawing=0123456789abcdef a.svg",
                          "(kerfline digest "}) {
    EXPECT_THAT(digests_in(bad), IsEmpty()) << bad;
  }
}

class StaleInputs : public testing::Test {
 protected:
  StaleInputs() {
    folder_ =
        std::filesystem::path{testing::TempDir()} /
        fmt::format("stale_{}", testing::UnitTest::GetInstance()->current_test_info()->name());
    std::filesystem::create_directories(folder_ / "below");
    write("below/a.svg", "one");
  }
  ~StaleInputs() override { std::filesystem::remove_all(folder_); }

  void write(const std::string& name, const std::string& text) const {
    std::ofstream{folder_ / name} << text;
  }
  static std::string program(const std::string& kind,
                             const std::string& text,
                             const std::string& name) {
    return "(" + text_of({kind, digest_of(text), name}) + ")\nG21\n";
  }
  [[nodiscard]] std::vector<std::string> stale(const std::string& text,
                                               DigestFiles files = DigestFiles::kAny) const {
    return stale_inputs(text, folder_.string(), files, nullptr);
  }

  std::filesystem::path folder_;
};

TEST_F(StaleInputs, AChangedFileIsNamedAndOneThatIsGoneIsNot) {
  EXPECT_THAT(stale(program("drawing", "one", "below/a.svg")), IsEmpty());
  EXPECT_THAT(
      stale(program("drawing", "two", "below/a.svg")),
      ElementsAre("the drawing below/a.svg has changed since this program was made; cut it again"));
  EXPECT_THAT(stale(program("rules", "two", "below/a.svg")),
              ElementsAre(HasSubstr("the rules below")));
  EXPECT_THAT(stale(program("drawing", "two", "gone.svg")), IsEmpty());
  EXPECT_THAT(stale(program("drawing", "two", "below")), IsEmpty());
  EXPECT_THAT(stale(program("kerf", "two", "below/a.svg")), IsEmpty()) << "names no file";
  EXPECT_THAT(stale(program("drawing", "two", "-")), IsEmpty());
}

TEST_F(StaleInputs, AFileOfBytesIsComparedAsATextIs) {
  write("photo.png", std::string{"\x89PNG\0\1", 6});
  for (const char* kind : {"picture", "part", "surface", "boundary"}) {
    EXPECT_THAT(stale(program(kind, std::string{"\x89PNG\0\1", 6}, "photo.png")), IsEmpty());
    EXPECT_THAT(stale(program(kind, "another", "photo.png")), testing::SizeIs(1)) << kind;
  }
}

TEST_F(StaleInputs, AProgramFromElsewhereReadsNothingOutsideTheFolder) {
  const std::string absolute = (folder_ / "below/a.svg").string();
  EXPECT_THAT(stale(program("drawing", "two", absolute)), testing::SizeIs(1));
  EXPECT_THAT(stale(program("drawing", "two", absolute), DigestFiles::kBelowFolder), IsEmpty());
  const std::string above = "../" + folder_.filename().string() + "/below/a.svg";
  EXPECT_THAT(stale(program("drawing", "two", above)), testing::SizeIs(1));
  EXPECT_THAT(stale(program("drawing", "two", above), DigestFiles::kBelowFolder), IsEmpty());
  EXPECT_THAT(stale(program("drawing", "two", "below/a.svg"), DigestFiles::kBelowFolder),
              testing::SizeIs(1));
}

TEST_F(StaleInputs, GivenSettingsAreComparedDefaultOnesAreNot) {
  const cnc::Settings settings;
  const auto with = [&](const std::string& digest, const char* name) {
    return stale_inputs(
        "(" + text_of({"settings", digest, name}) + ")\n", {}, DigestFiles::kAny, &settings);
  };
  EXPECT_THAT(with(digest_of(settings), "given"), IsEmpty());
  EXPECT_THAT(with(digest_of("other"), "given"), ElementsAre(HasSubstr("cut it again with")));
  EXPECT_THAT(with(digest_of("other"), "default"), IsEmpty());
  EXPECT_THAT(stale("(" + text_of({"settings", digest_of("other"), "given"}) + ")\n"), IsEmpty());
}

}  // namespace
}  // namespace sim
