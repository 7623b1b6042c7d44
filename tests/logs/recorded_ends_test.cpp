#include "logs/recorded_ends.hpp"

#include <gtest/gtest.h>

namespace autoref::logs {
namespace {

TEST(RecordedEnds, AreThoseInThePackets) {
  RecordedEnds ends(Side::kWest, true);
  league::RefereePacket packet;
  packet.set_blue_team_on_positive_half(false);
  ends.add(packet, Stage::kFirstHalfPre);
  EXPECT_EQ(ends.yellow(), Side::kEast);
  ends.add(packet, Stage::kSecondHalfPre);
  EXPECT_EQ(ends.yellow(), Side::kEast) << "the packet knows better";
}

TEST(RecordedEnds, ChangeBeforeEveryHalfAfterTheFirst) {
  RecordedEnds ends(Side::kEast, true);
  const league::RefereePacket silent;
  const auto after = [&](Stage stage) {
    ends.add(silent, stage);
    return ends.yellow();
  };
  EXPECT_EQ(after(Stage::kFirstHalf), Side::kEast);
  EXPECT_EQ(after(Stage::kHalfTime), Side::kEast);
  EXPECT_EQ(after(Stage::kSecondHalfPre), Side::kWest);
  EXPECT_EQ(after(Stage::kSecondHalfPre), Side::kWest);
  EXPECT_EQ(after(Stage::kSecondHalf), Side::kWest);
  EXPECT_EQ(after(Stage::kExtraFirstHalfPre), Side::kEast);
  EXPECT_EQ(after(Stage::kExtraSecondHalfPre), Side::kWest);
}

TEST(RecordedEnds, StayUnderOtherBooks) {
  RecordedEnds ends(Side::kWest, false);
  ends.add({}, Stage::kSecondHalfPre);
  EXPECT_EQ(ends.yellow(), Side::kWest);
}

}  // namespace
}  // namespace autoref::logs
