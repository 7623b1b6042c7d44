#include "logs/game_event_comparison.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "league/game_event_message.hpp"
#include "tests/app/answer.hpp"
#include "tests/logs/sketched_log.hpp"
#include "tests/support/temporary_folder.hpp"

namespace autoref::logs {
namespace {

using Events = std::vector<game::TimedGameEvent>;

game::TimedGameEvent event_at(double time_s, GameEventType type, Side side = Side::kWest) {
  game::TimedGameEvent timed{time_s, {}};
  timed.event.type = type;
  timed.event.by_team = side;
  return timed;
}

constexpr GameEventType kOut = GameEventType::kBallLeftFieldTouchLine;
constexpr GameEventType kCrash = GameEventType::kBotCrashUnique;

GameEventComparison with_autoref(const Events& recorded, const Events& refereed,
                                 referee::Control control = referee::Control::kHuman) {
  return compared(recorded, refereed, control);
}

int matched(const Events& recorded, const Events& refereed) {
  return with_autoref(recorded, refereed).all.matched;
}

TEST(GameEventComparison, MatchesTheSameTypeAndTeamWithinTwoSeconds) {
  for (const double late_s : {-1.9, 0.0, 1.9})
    EXPECT_EQ(matched({event_at(10, kOut)}, {event_at(10 + late_s, kOut)}), 1) << late_s;
  for (const double late_s : {-2.1, 2.1})
    EXPECT_EQ(matched({event_at(10, kOut)}, {event_at(10 + late_s, kOut)}), 0) << late_s;
  EXPECT_EQ(matched({event_at(10, kOut)}, {event_at(10, kCrash)}), 0);
  EXPECT_EQ(matched({event_at(10, kOut)}, {event_at(10, kOut, Side::kEast)}), 0);
}

TEST(GameEventComparison, MatchesEventsOfNobody) {
  Events events = {event_at(10, GameEventType::kNoProgressInGame)};
  events.front().event.by_team.reset();
  EXPECT_EQ(matched(events, events), 1);
}

TEST(GameEventComparison, MatchesEachEventOnceInOrderOfTime) {
  const Events two = {event_at(10, kCrash), event_at(11, kCrash)};
  EXPECT_EQ(matched(two, two), 2);
  EXPECT_EQ(matched({two.front()}, two), 1);
  const GameEventComparison comparison = with_autoref(two, {two.begin() + 1, two.end()});
  ASSERT_EQ(comparison.pairs.size(), 2U);
  EXPECT_TRUE(comparison.pairs[0].is_matched());
  EXPECT_FALSE(comparison.pairs[1].refereed);
}

TEST(GameEventComparison, CountsByType) {
  const GameEventComparison comparison =
      with_autoref(Events{event_at(10, kOut), event_at(20, kCrash)},
                   Events{event_at(10.5, kOut), event_at(15, kOut)});
  EXPECT_EQ(comparison.types.at(kOut).recorded, 1);
  EXPECT_EQ(comparison.types.at(kOut).refereed, 2);
  EXPECT_EQ(comparison.types.at(kOut).matched, 1);
  EXPECT_EQ(comparison.types.at(kCrash).recorded, 1);
  EXPECT_EQ(comparison.types.at(kCrash).refereed, 0);
  EXPECT_EQ(comparison.all.recorded, 2);
  EXPECT_EQ(comparison.pairs[1].refereed->time_s, 15);
  EXPECT_FALSE(comparison.pairs[1].recorded);
}

// Substitutions, challenges and emergency stops are requests of teams; other types need a person.
TEST(GameEventComparison, CountsWhatAutoRefNeverJudgesApart) {
  for (const GameEventType type :
       {GameEventType::kBotSubstitution, GameEventType::kChallengeFlag,
        GameEventType::kChallengeFlagHandled, GameEventType::kEmergencyStop,
        GameEventType::kUnsportingBehaviorMajor, GameEventType::kBotTippedOver,
        static_cast<GameEventType>(99)}) {
    const GameEventComparison comparison = with_autoref(Events{event_at(10, type)}, {});
    EXPECT_EQ(comparison.all.recorded, 0) << static_cast<int>(type);
    EXPECT_EQ(comparison.not_judged.at(type), 1);
  }
  for (const referee::Control control : {referee::Control::kHuman, referee::Control::kAutoref}) {
    EXPECT_TRUE(is_judged(GameEventType::kTooManyRobots, control));
    EXPECT_TRUE(is_judged(GameEventType::kPossibleGoal, control));
  }
}

// Beside a person, cards and placements are the person's.
TEST(GameEventComparison, CountsWhatThePersonDecidesApart) {
  for (const GameEventType type :
       {GameEventType::kPlacementSucceeded, GameEventType::kMultipleCards}) {
    EXPECT_EQ(with_autoref({event_at(10, type)}, {}).not_judged.at(type), 1);
    EXPECT_EQ(with_autoref({event_at(10, type)}, {}, referee::Control::kAutoref).all.recorded, 1);
  }
}

// The sketched ball crosses the touch line 4 s after the start; nobody has touched it.
class LogWithGameEvents : public testing::Test {
 protected:
  void write(bool has_events) const {
    SketchedLog sketch;
    sketch.change_referee = [has_events](double time_s, league::RefereePacket& packet) {
      packet.clear_game_events();
      if (!has_events || time_s < 5) return;
      GameEvent out;
      out.type = kOut;
      out.id = "a";
      league::add_game_event(out, packet);
      GameEvent substitution;
      substitution.type = GameEventType::kBotSubstitution;
      substitution.id = "b";
      league::add_game_event(substitution, packet);
    };
    write_sketch(sketch, log_);
  }
  nlohmann::json compare() const {
    const app::Answer answer = app::answer_to({"referee", "log", log_.c_str(), "--json"});
    return nlohmann::json::parse(answer.out)["game_events"];
  }

  TemporaryFolder folder_;
  std::string log_ = folder_ / "game.log";
};

TEST_F(LogWithGameEvents, IsComparedWithAutoRef) {
  write(true);
  const nlohmann::json events = compare();
  EXPECT_EQ(events["recorded"], 1);
  EXPECT_EQ(events["right"], 1) << events;
  EXPECT_EQ(events["not_judged"][0]["type"], "BOT_SUBSTITUTION");
  const app::Answer text = app::answer_to({"referee", "log", log_.c_str()});
  EXPECT_NE(text.out.find("not judged  1 BOT_SUBSTITUTION"), std::string::npos) << text.out;
}

TEST_F(LogWithGameEvents, HasNoTableWithoutThem) {
  write(false);
  EXPECT_TRUE(compare().is_null());
  const app::Answer text = app::answer_to({"referee", "log", log_.c_str()});
  EXPECT_EQ(text.out.find("game event"), std::string::npos) << text.out;
}

TEST_F(LogWithGameEvents, IsRefereedIntoAFileOfGameEvents) {
  write(true);
  const std::string file = folder_ / "events.jsonl";
  const app::Answer answer =
      app::answer_to({"referee", "log", log_.c_str(), "--game-events", file.c_str()});
  EXPECT_EQ(answer.code, 0) << answer.err;
  const nlohmann::json event = nlohmann::json::parse(content_of(file));
  EXPECT_EQ(event["type"], "BALL_LEFT_FIELD_TOUCH_LINE");
  EXPECT_EQ(event["origin"][0], "AutoRef");
  EXPECT_EQ(event["ball_left_field_touch_line"]["by_team"], "UNKNOWN");
}

}  // namespace
}  // namespace autoref::logs
