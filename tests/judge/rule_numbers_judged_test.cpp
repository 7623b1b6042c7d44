// The numbers of a rule book, turned up and down: the ground truth has fewer events where the rules
// allow more, and the referee still agrees with it.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "game/settings/fields.hpp"
#include "judge/evaluate_calls.hpp"
#include "judge/judge_tally.hpp"
#include "soccer/rules/rule_book.hpp"

namespace autoref::judge {
namespace {

// A number that decides how often an event happens.
struct DecisiveNumber {
  const char* book;
  const char* name;
  const char* event;
  double strict;  // the event happens more often
  double lenient;
};

constexpr DecisiveNumber kDecisive[] = {
    {"2026-b", "kick_limit_mps", "bot_kicked_ball_too_fast", 4, 8},
    {"2026-b", "opponents_to_ball_m", "defender_too_close_to_kick_point", 0.8, 0.25},
    {"2026-b", "attacker_to_area_m", "attacker_stays_near_area", 0.8, 0.05},
    {"2026-b", "stop_speed_mps", "bot_too_fast_in_stop", 0.8, 3},
    {"2026-b", "foul_repeat_s", "defender_too_close_to_kick_point", 0.5, 6},
    {"2026-b", "double_touch_m", "attacker_double_touched_ball", 0.05, 1},
    {"2014", "dribbling_m", "bot_dribbled_ball_too_far", 0.25, 1.5},
    {"2014", "stop_distance_grace_s", "stop_distance", 0.5, 8},
    {"2014", "retakes", "defender_too_close_to_kick_point", 20, 0},
};

// The calls in games of rowdy against itself under a rule book with a changed number.
CameraTally judged(const char* book, const std::string& number, const std::string& value) {
  constexpr int kGames = 3;
  CameraTally tally;
  for (int seed = 1; seed <= kGames; ++seed) {
    game::GameSettings settings;
    for (const auto& [path, text] :
         std::vector<std::pair<std::string, std::string>>{{"match.rules", book},
                                                          {"a.strategy", "rowdy"},
                                                          {"b.strategy", "rowdy"},
                                                          {"match.half_s", "60"},
                                                          {"seed", std::to_string(seed)},
                                                          {"match.rule." + number, value}}) {
      game::set_by_path(settings, path, text);
    }
    const EvaluatedGame game = evaluate_calls(game::resolved(settings));
    tally.add(game.record, game.evaluation);
  }
  return tally;
}

EventTally judged(const DecisiveNumber& number, double value) {
  return judged(number.book, number.name, fmt::format("{}", value)).events[number.event];
}

TEST(RuleNumbersJudged, AreFollowedByRefereeAndGroundTruth) {
  EventTally all;
  for (const DecisiveNumber& number : kDecisive) {
    const EventTally strict = judged(number, number.strict);
    const EventTally lenient = judged(number, number.lenient);
    EXPECT_GT(strict.happened(), lenient.happened()) << number.book << " " << number.name;
    EXPECT_GT(strict.calls(), lenient.calls()) << number.book << " " << number.name;
    all.add(strict);
    all.add(lenient);
  }
  EXPECT_GT(all.happened(), 50);
  EXPECT_GT(all.f1().value(), 0.95);
}

// Under the rules of 2026, positions are judged while a restart is pending, whether or not fouls
// stop play; under the Laws, when the ball enters play.
TEST(RuleNumbersJudged, TheEditionDecidesWhenPositionsAreJudged) {
  CameraTally stopping = judged("2026-b", "fouls_stop_play", "true");
  EXPECT_GT(stopping.events["attacker_stays_near_area"].happened(), 2);
  EXPECT_GT(stopping.events["attacker_stays_near_area"].f1().value(), 0.9);
  EXPECT_GT(stopping.events["defender_too_close_to_kick_point"].happened(), 2);
  EXPECT_GT(stopping.events["defender_too_close_to_kick_point"].f1().value(), 0.75);
  EXPECT_EQ(stopping.events["attacker_too_close_to_defense_area"].calls(), 0);
  CameraTally counting = judged("2014", "fouls_stop_play", "false");
  EXPECT_EQ(counting.events["attacker_stays_near_area"].calls(), 0);
  EXPECT_GT(counting.events["defender_too_close_to_kick_point"].happened(), 2);
  EXPECT_GT(counting.events["defender_too_close_to_kick_point"].f1().value(), 0.9);
}

}  // namespace
}  // namespace autoref::judge
