#include "runner/view/decision_lines.hpp"

#include <gtest/gtest.h>

#include "runner/game/event_log.hpp"
#include "runner/io/errors.hpp"

namespace autoref::runner {
namespace {

std::string line_of(referee::Event event) {
  referee::Decision decision;
  decision.time_s = 12.5;
  decision.finding.event = event;
  decision.finding.rule = "paper 4.2";
  decision.finding.offender = Side::kEast;
  decision.finding.card = referee::Card::kYellow;
  decision.card_reason = "3rd foul";
  decision.finding.position_m = Vec2(1, -2);
  decision.finding.evidence = "He said \"no\" <twice>.";
  return decision_json(decision) + "\n";
}

std::string refusal_of(const std::string& lines) {
  try {
    decisions_for_page(lines, "events.jsonl");
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(DecisionLines, TellWhatAPageShows) {
  EXPECT_EQ(decisions_for_page(line_of(referee::Event::kBotPushedBot), "events.jsonl"),
            R"([{"time_s": 12.5, "event": "bot_pushed_bot", "rule": "paper 4.2", )"
            R"("reason": "He said \"no\" <twice>.", "offender": "blue", "card": "yellow", )"
            R"("card_reason": "3rd foul", "restart": null, "position_m": [1, -2]}])");
}

TEST(DecisionLines, LeaveOutThatTheGameTakesItsCourse) {
  EXPECT_EQ(decisions_for_page(line_of(referee::Event::kReady), "events.jsonl"), "[]");
}

TEST(DecisionLines, AreRefusedWithFileAndLine) {
  for (const char* wrong : {"{", "[1]", "{\"event\": \"goal\"}", "{\"time_s\": 1}",
                            "{\"event\": \"goal\", \"time_s\": \"soon\"}"}) {
    const std::string message = refusal_of(line_of(referee::Event::kGoal) + wrong);
    EXPECT_TRUE(message.starts_with("events.jsonl:2:1:")) << wrong << ": " << message;
  }
}

TEST(DecisionsForThePage, RefuseALineThatUnfoldsWithoutEnd) {
  for (const char* line : {"{event: &x [*x], time_s: 1}\n", "{event: goal, time_s: &x [*x]}\n",
                           "[[[[[[[[event]]]]]]]]\n"}) {
    EXPECT_TRUE(refusal_of(line).starts_with("events.jsonl:1:1: ")) << refusal_of(line);
  }
  const std::string huge =
      "{event: goal, time_s: 1, evidence: " + std::string(100'000, 'a') + "}\n";
  EXPECT_TRUE(refusal_of(huge).starts_with("events.jsonl:1:1: "));
}

}  // namespace
}  // namespace autoref::runner
