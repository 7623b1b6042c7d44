#include "experiments/scenes/continuation.hpp"

#include <gtest/gtest.h>

#include <exception>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "experiments/results/game_row.hpp"
#include "io/json.hpp"
#include "io/table.hpp"
#include "referee/decision.hpp"

namespace autoref::experiments {
namespace {

using game::SceneEnd;
using referee::Event;
using referee::State;

const PerSide<std::string> kNames{{"basic (a)", "zone"}};

referee::Decision decision_of(Event event, double time_s, State from = State::kRun,
                              State to = State::kWaitStop) {
  referee::Decision decision;
  decision.time_s = time_s;
  decision.from = from;
  decision.to = to;
  decision.finding.event = event;
  decision.stage = Stage::kFirstHalf;
  return decision;
}

// A goal by `scorer`, after which the other side kicks off.
referee::Decision goal_decision(Side scorer, double time_s) {
  referee::Decision decision = decision_of(Event::kGoal, time_s);
  decision.finding.restart = {CommandKind::kPrepareKickoff, opponent_of(scorer)};
  return decision;
}

// What follows in a game with these decisions.
Continuation continuation_after(const std::vector<referee::Decision>& decisions,
                                const game::GameRecord& record = {}, Side a_plays = Side::kWest) {
  ContinuationObserver observer;
  for (const referee::Decision& decision : decisions) observer.on_decision(decision);
  game::GameConfiguration game;
  game.seed = 43;
  game.match.a_plays = a_plays;
  return observer.continuation(game, record);
}

TEST(ContinuationObserver, NotesTheFirstDecisionThatEndsPlay) {
  const Continuation found =
      continuation_after({decision_of(Event::kReady, 0.5, State::kWaitStart, State::kRun),
                          decision_of(Event::kBotKickedBallTooFast, 1, State::kRun, State::kRun),
                          decision_of(Event::kThrowIn, 2.5), goal_decision(Side::kWest, 9)});
  ASSERT_TRUE(found.first_end);
  EXPECT_EQ(found.first_end->end, SceneEnd::kBallOut);
  EXPECT_EQ(found.first_end->after_s, 2.5);
  EXPECT_FALSE(found.first_end->scorer);
}

TEST(ContinuationObserver, CreditsAGoalToTheOpponentsOfTheSideThatKicksOff) {
  const Continuation found = continuation_after({goal_decision(Side::kEast, 3)});
  EXPECT_EQ(found.first_end.value().end, SceneEnd::kGoal);
  EXPECT_EQ(found.first_end.value().scorer, Side::kEast);
  EXPECT_EQ(found.next_goal.value().scorer, Side::kEast);
}

TEST(ContinuationObserver, NotesOnlyTheNextGoal) {
  const Continuation found =
      continuation_after({decision_of(Event::kStuckBall, 2), goal_decision(Side::kEast, 30),
                          goal_decision(Side::kWest, 60)});
  EXPECT_EQ(found.first_end.value().end, SceneEnd::kStop);
  EXPECT_EQ(found.next_goal.value().scorer, Side::kEast);
  EXPECT_EQ(found.next_goal.value().after_s, 30);
}

TEST(ContinuationObserver, TakesTheEndOfAHalfForAStop) {
  EXPECT_EQ(continuation_after({decision_of(Event::kHalfOver, 5)}).first_end.value().end,
            SceneEnd::kStop);
}

TEST(ContinuationObserver, FindsNothingIfTheGameEndsDuringAStop) {
  const Continuation found =
      continuation_after({decision_of(Event::kGameOver, 5, State::kWaitStop, State::kOver)});
  EXPECT_FALSE(found.first_end);
  EXPECT_FALSE(found.next_goal);
}

TEST(ContinuationObserver, IgnoresGoalsInShootouts) {
  referee::Decision goal = goal_decision(Side::kWest, 900);
  goal.stage = Stage::kShootout;
  const Continuation found = continuation_after({goal});
  EXPECT_FALSE(found.first_end);
  EXPECT_FALSE(found.next_goal);
}

TEST(ContinuationObserver, TakesTheSeedAndTheScoreBySide) {
  game::GameRecord record;
  record.goals_a = 3;
  record.goals_b = 1;
  const Continuation found = continuation_after({}, record, Side::kEast);
  EXPECT_EQ(found.seed, 43U);
  EXPECT_EQ(found.goals, (PerSide<int>{{1, 3}}));
  EXPECT_EQ(found.winner, Side::kEast);
}

TEST(ContinuationObserver, FindsNoWinnerOfADraw) { EXPECT_FALSE(continuation_after({}).winner); }

TEST(ContinuationObserver, LetsAShootoutDecideADraw) {
  game::GameRecord record;
  record.shootout = {2, 4};
  EXPECT_EQ(continuation_after({}, record).winner, Side::kEast);
}

TEST(ContinuationObserver, KeepsTheScoreOfAForfeitedGameThatTheTeamLost) {
  game::GameRecord record;
  record.goals_a = 2;
  record.status = game::Status::kForfeit;
  record.end_reason = game::EndReason::kForfeitA;
  record.void_reason = "team a crashed";
  const Continuation found = continuation_after({}, record);
  EXPECT_EQ(found.void_reason, "");
  EXPECT_EQ(found.goals[Side::kWest], 2);
  EXPECT_EQ(found.winner, Side::kEast);
}

TEST(ContinuationObserver, KeepsOnlySeedAndReasonOfAVoidGame) {
  const Continuation found =
      continuation_after({goal_decision(Side::kWest, 3)}, void_record("a test"));
  EXPECT_EQ(found.seed, 43U);
  EXPECT_EQ(found.void_reason, "a test");
  EXPECT_FALSE(found.first_end);
}

Continuation read_again(const Continuation& one) {
  return continuation_in(io::Json::parse(io::json_text(json_of(one))));
}

TEST(ContinuationJson, ReadsBackAsTheSameContinuation) {
  const Continuation one{.seed = 18446744073709551615U,
                         .first_end = FollowingEvent{0.1 + 0.2, SceneEnd::kFoul},
                         .next_goal = FollowingEvent{12, SceneEnd::kGoal, Side::kEast},
                         .goals = {{1, 2}},
                         .winner = Side::kEast};
  const Continuation again = read_again(one);
  EXPECT_EQ(again.seed, one.seed);
  EXPECT_EQ(again.void_reason, "");
  EXPECT_EQ(again.first_end.value().after_s, 0.1 + 0.2);
  EXPECT_EQ(again.first_end.value().end, SceneEnd::kFoul);
  EXPECT_FALSE(again.first_end.value().scorer);
  EXPECT_EQ(again.next_goal.value().after_s, 12);
  EXPECT_EQ(again.next_goal.value().scorer, Side::kEast);
  EXPECT_EQ(again.goals, one.goals);
  EXPECT_EQ(again.winner, Side::kEast);
}

TEST(ContinuationJson, ReadsBackMissingEventsAndAVoidReason) {
  const Continuation again = read_again({.seed = 7, .void_reason = "line 1\nline \"2\""});
  EXPECT_EQ(again.void_reason, "line 1\nline \"2\"");
  EXPECT_FALSE(again.first_end);
  EXPECT_FALSE(again.next_goal);
  EXPECT_FALSE(again.winner);
}

TEST(ContinuationJson, RefusesOtherObjects) {
  EXPECT_THROW(continuation_in(io::Json::object()), std::exception);
  EXPECT_THROW(continuation_in(io::Json()), std::exception);
  io::Json json = json_of(Continuation{.seed = 1});
  json["winner"] = "green";
  EXPECT_THROW(continuation_in(json), std::exception);
  json = json_of(Continuation{.seed = 1, .first_end = FollowingEvent{}});
  json["first_end"]["end"] = "tea";
  EXPECT_THROW(continuation_in(json), std::exception);
}

// A game with a goal by yellow in play, one in which blue scores later, and one without events.
std::vector<Continuation> three_games() {
  return {{.seed = 43,
           .first_end = FollowingEvent{1.5, SceneEnd::kGoal, Side::kWest},
           .next_goal = FollowingEvent{1.5, SceneEnd::kGoal, Side::kWest},
           .goals = {{3, 0}},
           .winner = Side::kWest},
          {.seed = 44,
           .first_end = FollowingEvent{4.2, SceneEnd::kFoul},
           .next_goal = FollowingEvent{100, SceneEnd::kGoal, Side::kEast},
           .goals = {{1, 3}},
           .winner = Side::kEast},
          {.seed = 45, .goals = {{1, 1}}}};
}

std::string continuation_text(const std::vector<Continuation>& games, bool is_scene = false) {
  return io::text_of(continuations_table(games, kNames, is_scene), 1000);
}

// Wilson's interval of 1 in 3 is [0.0615, 0.7923]; the exact one of 0 in 3 ends at 1 - 0.025^(1/3),
// which is 0.7076.
TEST(ContinuationsTable, ShowsHowPlayEndsAndTheNextGoalAndTheResults) {
  EXPECT_EQ(continuation_text(three_games()),
            "play ends with        games   share [95 %]   after [s]   seed\n"
            "a goal by basic (a)       1   33 % [6, 79]         1.5     43\n"
            "a goal by zone            0    0 % [0, 71]           -      -\n"
            "a foul                    1   33 % [6, 79]         4.2     44\n"
            "the end of the game       1   33 % [6, 79]           -     45\n"
            "\n"
            "next goal   games   share [95 %]   after [s]   seed\n"
            "basic (a)       1   33 % [6, 79]         1.5     43\n"
            "zone            1   33 % [6, 79]       100.0     44\n"
            "none            1   33 % [6, 79]           -     45\n"
            "\n"
            "result           games   share [95 %]   seed\n"
            "basic (a) wins       1   33 % [6, 79]     43\n"
            "a draw               1   33 % [6, 79]     45\n"
            "zone wins            1   33 % [6, 79]     44\n"
            "final score: 1.67 : 1.33 on average\n");
}

TEST(ContinuationsTable, ShowsOnlyHowPlayEndsInScenes) {
  const std::string text = continuation_text(three_games(), true);
  EXPECT_NE(text.find("\nnothing in that time       1   33 % [6, 79] "), std::string::npos) << text;
  EXPECT_EQ(text.find("next goal"), std::string::npos);
  EXPECT_EQ(text.find("final score"), std::string::npos);
}

TEST(ContinuationsTable, NamesEveryOtherEnd) {
  const std::string text =
      continuation_text({{.seed = 1, .first_end = FollowingEvent{1, SceneEnd::kBallOut}},
                         {.seed = 2, .first_end = FollowingEvent{2, SceneEnd::kStop}}});
  EXPECT_NE(text.find("\nthe ball out of the field "), std::string::npos) << text;
  EXPECT_NE(text.find("\nanother stop, or the end of the half "), std::string::npos) << text;
}

TEST(ContinuationsTable, LeavesVoidGamesOutOfTheSharesAndReportsThem) {
  std::vector<Continuation> games = three_games();
  games.insert(games.begin(), {.seed = 42, .void_reason = "the first"});
  games.push_back({.seed = 46, .void_reason = "the second"});
  EXPECT_EQ(continuation_text(games),
            continuation_text(three_games()) + "\n2 games were void: the first\n");
}

TEST(ContinuationsTable, OnlyReportsVoidGamesIfAllAreVoid) {
  EXPECT_EQ(continuation_text({{.seed = 42, .void_reason = "a test"}}),
            "1 game was void: a test\n");
}

TEST(ContinuationsTable, IsEmptyWithoutGames) { EXPECT_EQ(continuation_text({}), ""); }

// 15 games with a goal by yellow after 1 s, 2 s, ..., 15 s, and 5 games that a foul interrupts.
std::vector<Continuation> twenty_games() {
  std::vector<Continuation> games;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Continuation game{.seed = seed};
    const auto after_s = static_cast<double>(seed);
    if (seed <= 15) {
      game.first_end = FollowingEvent{after_s, SceneEnd::kGoal, Side::kWest};
    } else {
      game.first_end = FollowingEvent{after_s, SceneEnd::kFoul};
    }
    games.push_back(game);
  }
  return games;
}

// The intervals are those of proportion_interval_test.cpp, from SciPy.
TEST(ContinuationsJson, HasTheShareItsIntervalTheMedianTimeAndTheFirstSeedOfEachEnd) {
  const io::Json ends = continuations_json(twenty_games(), kNames, true)["play_ends"];
  ASSERT_EQ(ends.size(), 3U);
  EXPECT_EQ(ends[0]["end"], "goal");
  EXPECT_EQ(ends[0]["scorer"], "yellow");
  EXPECT_EQ(ends[0]["games"], 15);
  EXPECT_EQ(ends[0]["share"], 0.75);
  EXPECT_NEAR(ends[0]["low"].get<double>(), 0.5312991223812561, 1e-10);
  EXPECT_NEAR(ends[0]["high"].get<double>(), 0.8881382985923344, 1e-10);
  EXPECT_EQ(ends[0]["median_s"], 8);
  EXPECT_EQ(ends[0]["seed"], 1);
  EXPECT_EQ(ends[2]["end"], "foul");
  EXPECT_EQ(ends[2]["scorer"], nullptr);
  EXPECT_EQ(ends[2]["seed"], 16);
}

TEST(ContinuationsJson, KeepsTheGoalsOfASideThatNeverScored) {
  const io::Json goal = continuations_json(twenty_games(), kNames, true)["play_ends"][1];
  EXPECT_EQ(goal["scorer"], "blue");
  EXPECT_EQ(goal["games"], 0);
  EXPECT_EQ(goal["low"], 0);
  EXPECT_NEAR(goal["high"].get<double>(), 0.16843347098308548, 1e-10);
  EXPECT_EQ(goal["median_s"], nullptr);
  EXPECT_EQ(goal["seed"], nullptr);
}

std::vector<std::string> keys_of(const io::Json& json) {
  std::vector<std::string> keys;
  for (const auto& [key, value] : json.items()) keys.push_back(key);
  return keys;
}

TEST(ContinuationsJson, HasTheNextGoalAndTheResultsOfGames) {
  const io::Json json = continuations_json(three_games(), kNames, false);
  EXPECT_EQ(keys_of(json),
            (std::vector<std::string>{"teams", "games", "void_games", "play_ends", "next_goal",
                                      "results", "mean_goals", "each"}));
  EXPECT_EQ(json["teams"], (io::Json{{"yellow", "basic (a)"}, {"blue", "zone"}}));
  EXPECT_EQ(json["play_ends"][3]["end"], "game_over");
  EXPECT_EQ(json["next_goal"][1]["scorer"], "blue");
  EXPECT_EQ(json["next_goal"][2]["scorer"], nullptr);
  EXPECT_EQ(json["results"][0]["result"], "yellow_wins");
  EXPECT_EQ(json["results"][1]["result"], "draw");
  EXPECT_EQ(json["results"][2]["result"], "blue_wins");
  EXPECT_EQ(keys_of(json["results"][0]),
            (std::vector<std::string>{"result", "games", "share", "low", "high", "seed"}));
  EXPECT_DOUBLE_EQ(json["mean_goals"]["yellow"].get<double>(), 5 / 3.0);
}

TEST(ContinuationsJson, HasOnlyTheEndsOfPlayInScenes) {
  const io::Json json = continuations_json(three_games(), kNames, true);
  EXPECT_EQ(keys_of(json),
            (std::vector<std::string>{"teams", "games", "void_games", "play_ends", "each"}));
  EXPECT_EQ(json["play_ends"][3]["end"], "time");
}

TEST(ContinuationsJson, ListsEveryGameAndCountsTheVoidOnes) {
  std::vector<Continuation> games = three_games();
  games.push_back({.seed = 46, .void_reason = "a test"});
  const io::Json json = continuations_json(games, kNames, false);
  EXPECT_EQ(json["games"], 4);
  EXPECT_EQ(json["void_games"], 1);
  EXPECT_NEAR(json["play_ends"][0]["share"].get<double>(), 1 / 3.0, 1e-12);
  ASSERT_EQ(json["each"].size(), 4U);
  EXPECT_EQ(json["each"][3], json_of(games[3]));
}

TEST(ContinuationsJson, HasNoMeansIfAllGamesAreVoid) {
  const io::Json json = continuations_json({{.seed = 42, .void_reason = "a test"}}, kNames, false);
  EXPECT_EQ(json["mean_goals"]["yellow"], nullptr);
  EXPECT_EQ(json["play_ends"][0]["share"], nullptr);
}

}  // namespace
}  // namespace autoref::experiments
