#include "firmware/protocol/reply.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>

#include "tests/support/random_source.hpp"
#include "tests/support/trials.hpp"

namespace cnc {
namespace {

std::string value(float number, std::uint32_t least) {
  std::array<char, Reply::kCapacity> bytes{};
  return std::string{Reply{bytes}.value(number, least).view()};
}
std::string place(std::int64_t nanometres, bool inches) {
  std::array<char, Reply::kCapacity> bytes{};
  return std::string{Reply{bytes}.place(Coordinate{nanometres}, inches).view()};
}

TEST(Reply, WritesSettingsWithAsManyDecimalsAsTheyHave) {
  EXPECT_EQ(value(0.01F, 3), "0.010");
  EXPECT_EQ(value(0.0205F, 3), "0.0205");
  EXPECT_EQ(value(333.33F, 3), "333.330");
  EXPECT_EQ(value(12000.0F, 3), "12000.000");
  EXPECT_EQ(value(-5.0F, 3), "-5.000");
  EXPECT_EQ(value(1.0e9F, 3), "1000000000.000");
  EXPECT_EQ(value(0.9999999F, 3), "1.000");
  EXPECT_EQ(value(600.0F, 0), "600");
  EXPECT_EQ(value(0.5F, 0), "0.5");
}

TEST(Reply, WritesEveryValueToTheDigitsOfAFloat) {
  proof::Random random{proof::test_seed()};
  for (int k = 0; k < 100'000; ++k) {
    const auto number = static_cast<float>(random.signed_magnitude(0.001, 1.0e6));
    const double read = std::stod(value(number, 3));
    EXPECT_NEAR(read,
                static_cast<double>(number),
                std::max(7.0e-7, 7.0e-7 * std::abs(static_cast<double>(number))));
  }
}

TEST(Reply, WritesPlacesRoundedToThousandthsOfAMillimetre) {
  EXPECT_EQ(place(0, false), "0.000");
  EXPECT_EQ(place(1'234'567, false), "1.235");
  EXPECT_EQ(place(-1'234'499, false), "-1.234");
  EXPECT_EQ(place(-499, false), "0.000");
  EXPECT_EQ(place(Coordinate::kFarthestNanometres, false), "1000000.000");
}

TEST(Reply, WritesPlacesInTenThousandthsOfAnInch) {
  EXPECT_EQ(place(25'400'000, true), "1.0000");
  EXPECT_EQ(place(-12'700'000, true), "-0.5000");
  EXPECT_EQ(place(1'270, true), "0.0001");
}

TEST(Reply, CutsOffWhatDoesNotFitButKeepsItsEnd) {
  std::array<char, Reply::kCapacity> bytes{};
  Reply reply{bytes};
  for (int k = 0; k < 100; ++k) reply.text("0123456789");
  reply.end();
  EXPECT_EQ(reply.view().size(), Reply::kCapacity);
  EXPECT_TRUE(reply.view().ends_with("\r\n"));
}

}  // namespace
}  // namespace cnc
