#include "logs/calls.hpp"

#include <gtest/gtest.h>

#include "io/errors.hpp"

namespace autoref::logs {
namespace {

std::string error_of(const std::string& text) {
  try {
    annotations_in(text, "mine.csv");
  } catch (const io::InputError& error) {
    return error.what();
  }
  return "";
}

TEST(Annotations, AreReadInOrderOfTime) {
  const std::vector<Call> calls =
      annotations_in("time,call,side\r\n1:23.5,goal,yellow\r\n\r\n12,throw_in,", "mine.csv");
  ASSERT_EQ(calls.size(), 2U);
  EXPECT_EQ(calls[0].stop_s, 12.0);
  EXPECT_EQ(calls[0].event, "throw_in");
  EXPECT_FALSE(calls[0].side);
  EXPECT_EQ(calls[1].stop_s, 83.5);
  EXPECT_EQ(calls[1].event, "goal");
  EXPECT_EQ(calls[1].side, Side::kWest);
}

TEST(Annotations, AreRefusedWithTheirLine) {
  EXPECT_EQ(error_of("time,side\n"), "mine.csv:1:1: the first line must be time,call,side");
  EXPECT_EQ(error_of(""), "mine.csv:1:1: the first line must be time,call,side");
  const std::string head = "time,call,side\n";
  EXPECT_EQ(error_of(head + "1,goal\n"),
            "mine.csv:2:1: has 2 cells; expected three: time, call, side");
  EXPECT_EQ(error_of(head + "\n1:70,goal,blue\n"),
            "mine.csv:3:1: '1:70' is not a time such as 83.2 or 1:23.2");
  EXPECT_EQ(error_of(head + "nan,goal,blue\n"),
            "mine.csv:2:1: 'nan' is not a time such as 83.2 or 1:23.2");
  EXPECT_EQ(error_of(head + "1,throwin,blue\n"),
            "mine.csv:2:1: unknown call 'throwin'; did you mean 'throw_in'?");
  EXPECT_EQ(error_of(head + "1,begin,blue\n"), "mine.csv:2:1: unknown call 'begin'");
  EXPECT_EQ(error_of(head + "1,goal,west\n"),
            "mine.csv:2:1: 'west' is not a side: write yellow, blue, or nothing");
}

Call call_at(double time_s, std::string_view event, std::optional<Side> side) {
  return {time_s, time_s, {}, event, side};
}

TEST(Annotations, MatchCallsOfTheSameEventAndSideNearby) {
  const std::vector<Call> annotated = {call_at(10, "goal", Side::kWest)};
  const auto right = [&](const Call& call) {
    return agreement_with_annotations(annotated, std::vector<Call>{call}).right;
  };
  EXPECT_EQ(right(call_at(8.1, "goal", Side::kWest)), 1);
  EXPECT_EQ(right(call_at(11.9, "goal", Side::kWest)), 1);
  EXPECT_EQ(right(call_at(7.9, "goal", Side::kWest)), 0);
  EXPECT_EQ(right(call_at(12.1, "goal", Side::kWest)), 0);
  EXPECT_EQ(right(call_at(10, "goal", Side::kEast)), 0);
  EXPECT_EQ(right(call_at(10, "throw_in", Side::kWest)), 0);
}

TEST(Annotations, MatchEitherSideIfTheyNameNone) {
  const std::vector<Call> annotated = {call_at(10, "goal", std::nullopt)};
  const std::vector<Call> called = {call_at(9, "goal", Side::kEast)};
  EXPECT_EQ(agreement_with_annotations(annotated, called).right, 1);
}

TEST(Annotations, AreMissedOrHaveAWrongCallBeside) {
  const std::vector<Call> annotated = {call_at(10, "goal", Side::kWest)};
  const std::vector<Call> called = {call_at(10.5, "throw_in", Side::kEast)};
  const Agreement agreement = agreement_with_annotations(annotated, called);
  ASSERT_EQ(agreement.pairs.size(), 2U);
  EXPECT_EQ(other_referee_text(agreement.pairs[0], agreement),
            "AutoRef: throw_in (blue) at 10.50 s");
  EXPECT_EQ(other_referee_text(agreement.pairs[1], agreement),
            "recorded: goal (yellow) at 10.00 s");
}

}  // namespace
}  // namespace autoref::logs
