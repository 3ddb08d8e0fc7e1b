#include "firmware/protocol/sender_part.hpp"

#include <gtest/gtest.h>

namespace cnc {
namespace {

TEST(SenderPart, IsTakenUntilItEnds) {
  SenderPart part;
  EXPECT_FALSE(part.taken());
  part.begin();
  part.note_resume();
  EXPECT_TRUE(part.taken());
  EXPECT_TRUE(part.resumes()) << "the lines before it are still to be done";
  part.end_resume();
  EXPECT_FALSE(part.resumes());
  EXPECT_TRUE(part.taken());
  part.end();
  EXPECT_FALSE(part.taken());
}

TEST(SenderPart, IsRefusedWithAReasonThatIsReportedOnce) {
  SenderPart part;
  EXPECT_FALSE(part.has_refusal());
  part.refuse("lines wait");
  EXPECT_FALSE(part.taken());
  EXPECT_TRUE(part.has_refusal());
  EXPECT_EQ(part.take_refusal(), "lines wait");
  EXPECT_FALSE(part.has_refusal());
}

}  // namespace
}  // namespace cnc
