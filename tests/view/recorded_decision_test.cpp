#include "view/game_recording.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "game/loop/event_log.hpp"
#include "io/errors.hpp"

namespace autoref::view {
namespace {

referee::Decision push() {
  referee::Decision decision;
  decision.time_s = 12.5;
  decision.finding.event = referee::Event::kBotPushedBot;
  decision.finding.rule = "paper 4.2";
  decision.finding.offender = Side::kEast;
  decision.finding.card = referee::Card::kYellow;
  decision.card_reason = "3rd foul";
  decision.finding.position_m = Vec2(1, -2);
  decision.finding.evidence = "He said \"no\" <twice>.";
  return decision;
}

std::string refusal_of_lines(const std::string& lines) {
  try {
    decisions_in(lines, "events.jsonl");
  } catch (const io::InputError& error) {
    return error.what();
  }
  return "accepted";
}

// A page shows the same from the event log as from the decision itself.
TEST(DecisionLines, AreReadBackUnchanged) {
  referee::Decision bare;
  bare.finding.rule = "paper 4.2";
  for (const referee::Decision& decision : {push(), bare}) {
    const auto read = decisions_in(game::decision_json(decision) + "\n", "events.jsonl");
    ASSERT_EQ(read.size(), 1U);
    EXPECT_EQ(read.front(), recorded(game::decision_object(decision)));
  }
}

TEST(RecordedDecision, HasTheWordsOfTheEventLog) {
  const RecordedDecision decision = recorded(game::decision_object(push()));
  EXPECT_EQ(decision.time_s, 12.5);
  EXPECT_EQ(decision.event, "bot_pushed_bot");
  EXPECT_EQ(decision.rule, "paper 4.2");
  EXPECT_EQ(decision.reason, "He said \"no\" <twice>.");
  EXPECT_EQ(decision.offender, "blue");
  EXPECT_EQ(decision.card, "yellow");
  EXPECT_EQ(decision.card_reason, "3rd foul");
  EXPECT_EQ(decision.position_m, Vec2(1, -2));
}

TEST(RecordedDecision, IsShownUnlessEveryGameHasIt) {
  EXPECT_TRUE(is_shown("bot_pushed_bot"));
  EXPECT_FALSE(is_shown("ready"));
}

TEST(DecisionLines, AreRefusedWithFileAndLine) {
  for (const char* wrong :
       {"{", "[1]", "{\"event\": \"goal\"}", "{\"time_s\": 1}",
        "{\"event\": \"goal\", \"time_s\": \"soon\"}", "{event: goal, time_s: 1}"}) {
    const std::string message = refusal_of_lines(game::decision_json(push()) + "\n" + wrong);
    EXPECT_TRUE(message.starts_with("events.jsonl:2:1:")) << wrong << ": " << message;
  }
}

TEST(DecisionLines, AreRefusedIfNestedTooDeeply) {
  EXPECT_TRUE(refusal_of_lines(std::string(100'000, '[')).starts_with("events.jsonl:1:1: "));
}

}  // namespace
}  // namespace autoref::view
