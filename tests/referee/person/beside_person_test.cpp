// Beside a person (paper, sections 4.1 and 5): AutoRef follows the person's commands, stops play on
// its own calls, and never restarts it.
#include "referee/person/beside_person.hpp"

#include <gtest/gtest.h>

#include <string>

#include "tests/referee/support/scripted_game.hpp"

namespace autoref::referee {
namespace {

Configuration commanded_by_person() {
  Configuration configuration;
  configuration.control = Control::kHuman;
  return configuration;
}

// A person who gives commands one after the other.
class Person {
 public:
  explicit Person(ScriptedGame& game) : game_(game) {}

  void gives(CommandKind kind, Side side = Side::kWest) {
    signal.command = {kind, side};
    ++signal.command_counter;
    game_.referee.follow(signal);
    const auto now = game_.referee.decisions();
    decision = now.empty() ? Decision{} : now.back();
  }

  RefereeSignal signal;
  Decision decision;  // that the command led to

 private:
  ScriptedGame& game_;
};

// A game beside a person, before any command.
struct PersonsGame {
  ScriptedGame game{commanded_by_person()};
  Person person{game};

  PersonsGame() {
    game.placement_works = false;
    game.line_up().run(0.1);
  }

  State state() const { return game.referee.state(); }

  void start_play() {
    person.gives(CommandKind::kStop);
    game.run(0.5);
    person.gives(CommandKind::kForceStart);
    game.run(0.1);
  }

  // Yellow 1 kicks the ball over the touch line.
  Decision kick_out() {
    game.kick_from(Side::kWest, 1, {0.5, 1.2}, {0, 3});
    return game.run_until("throw_in", 2);
  }
};

TEST(BesideAPerson, NothingHappensBeforeTheFirstCommand) {
  PersonsGame persons;
  persons.game.run(20);
  EXPECT_EQ(persons.state(), State::kInit);
  EXPECT_TRUE(persons.game.decisions.empty());
}

TEST(BesideAPerson, EveryCommandIsFollowed) {
  struct Case {
    CommandKind kind;
    State state;
  };
  const Case cases[] = {
      {CommandKind::kStop, State::kWaitStop},    {CommandKind::kPrepareKickoff, State::kWaitStop},
      {CommandKind::kNormalStart, State::kRun},  {CommandKind::kHalt, State::kDelayWait},
      {CommandKind::kStop, State::kWaitStop},    {CommandKind::kBallPlacement, State::kWaitStop},
      {CommandKind::kDirectFree, State::kRun},   {CommandKind::kGoal, State::kDelayWait},
      {CommandKind::kStop, State::kWaitStop},    {CommandKind::kTimeout, State::kTimeout},
      {CommandKind::kStop, State::kWaitStop},    {CommandKind::kPreparePenalty, State::kWaitStop},
      {CommandKind::kNormalStart, State::kRun},  {CommandKind::kForceStart, State::kRun},
      {CommandKind::kIndirectFree, State::kRun},
  };
  PersonsGame persons;
  for (const Case& one : cases) {
    persons.person.gives(one.kind, Side::kEast);
    EXPECT_EQ(persons.state(), one.state) << name_of(one.kind);
    EXPECT_EQ(persons.person.decision.finding.event, Event::kCommandGiven);
    EXPECT_EQ(persons.person.decision.command->kind, one.kind);
    persons.game.run(0.2);
    EXPECT_EQ(persons.state(), one.state) << "after " << name_of(one.kind);
  }
}

TEST(BesideAPerson, ARepeatedSignalIsNoCommand) {
  PersonsGame persons;
  persons.person.gives(CommandKind::kStop);
  persons.game.step();
  persons.game.referee.follow(persons.person.signal);
  EXPECT_TRUE(persons.game.referee.decisions().empty());
}

TEST(BesideAPerson, ScoreCardsAndStageArePersonal) {
  PersonsGame persons;
  persons.start_play();
  persons.person.signal.goals = {{2, 1}};
  persons.person.signal.yellow_cards[Side::kEast] = 1;
  persons.person.signal.robots_allowed[Side::kEast] = 5;
  persons.person.signal.stage = Stage::kFirstHalf;
  persons.game.referee.follow(persons.person.signal);
  const RefereeSignal& now = persons.game.step();
  EXPECT_EQ(now.goals, (PerSide<int>{{2, 1}}));
  EXPECT_EQ(now.yellow_cards[Side::kEast], 1);
  EXPECT_EQ(now.robots_allowed[Side::kEast], 5);
  EXPECT_EQ(now.stage, Stage::kFirstHalf);
  EXPECT_EQ(persons.game.referee.goals_by_half().back(), (PerSide<int>{{2, 1}}));
}

TEST(BesideAPerson, PlayBeginsWithTheRestartThatWasGiven) {
  PersonsGame persons;
  persons.person.gives(CommandKind::kStop);
  persons.game.run(0.2);
  persons.person.gives(CommandKind::kIndirectFree, Side::kEast);
  persons.game.run(0.2);
  EXPECT_FALSE(persons.game.referee.is_ball_in_play());
  persons.game.put_ball({0.2, 0});
  persons.game.run(0.2);
  EXPECT_TRUE(persons.game.referee.is_ball_in_play());
}

TEST(BesideAPerson, AnOwnCallSendsStopAndWaits) {
  PersonsGame persons;
  persons.start_play();
  const Decision call = persons.kick_out();
  EXPECT_EQ(call.to, State::kCalled);
  EXPECT_EQ(call.command->kind, CommandKind::kStop);
  EXPECT_EQ(call.restart(), (Command{CommandKind::kIndirectFree, Side::kEast}));
  persons.game.put_ball(call.finding.ball_to_m);
  persons.game.run(14);
  EXPECT_EQ(persons.state(), State::kCalled) << "restarted play by itself";
}

TEST(BesideAPerson, ABallThatLayInAGoalBeforePlayIsNotAGoal) {
  PersonsGame persons;
  persons.person.gives(CommandKind::kStop);
  persons.game.put_ball({3.1, 0});
  persons.game.run(0.5);
  persons.person.gives(CommandKind::kForceStart);
  persons.game.run(0.5);
  EXPECT_EQ(persons.game.count("goal"), 0);
  EXPECT_EQ(persons.game.count("goal_kick"), 1);
}

TEST(BesideAPerson, ThePersonsAnswerEndsTheWait) {
  PersonsGame persons;
  persons.start_play();
  persons.kick_out();
  persons.game.run(1);
  persons.person.gives(CommandKind::kStop);
  EXPECT_EQ(persons.state(), State::kWaitStop);
  EXPECT_EQ(persons.person.decision.finding.evidence, "The referee sent STOP.");
  persons.game.put_ball({0.5, 1.9});
  persons.game.run(3);
  persons.person.gives(CommandKind::kIndirectFree, Side::kEast);
  EXPECT_EQ(persons.state(), State::kRun);
  EXPECT_EQ(persons.person.decision.finding.evidence, "The referee sent INDIRECT_FREE_BLUE.");
}

TEST(BesideAPerson, ACommandThatContradictsTheCallIsNotedAndFollowed) {
  PersonsGame persons;
  persons.start_play();
  persons.kick_out();
  persons.game.run(1);
  persons.person.gives(CommandKind::kStop);
  persons.game.run(1);
  persons.person.gives(CommandKind::kIndirectFree, Side::kWest);
  EXPECT_EQ(persons.state(), State::kRun);
  EXPECT_NE(persons.person.decision.finding.evidence.find("contradicts the call throw_in"),
            std::string::npos)
      << persons.person.decision.finding.evidence;
}

TEST(BesideAPerson, WithoutAnAnswerTheCallIsOverruledAndNotMadeTwice) {
  PersonsGame persons;
  persons.start_play();
  const Decision call = persons.kick_out();
  persons.game.ball_mps = Vec2(0, 0);
  const Decision overruled = persons.game.run_until("overruled", 20);
  EXPECT_NEAR(overruled.time_s - call.time_s, 15, 0.02);
  EXPECT_EQ(overruled.to, State::kRun);
  persons.game.run(5);  // the ball is still outside
  EXPECT_EQ(persons.game.count("throw_in"), 1);
  persons.game.put_ball({0.5, 0});
  persons.game.run(2);
  persons.kick_out();
  EXPECT_EQ(persons.game.count("throw_in"), 2) << "the ball left the field again";
}

TEST(BesideAPerson, PlayThatVisiblyGoesOnOverrulesTheCall) {
  PersonsGame persons;
  persons.start_play();
  const Decision call = persons.kick_out();
  persons.game.put_ball({0.5, 0});
  for (int i = 0; i < 10 * 60 && persons.state() == State::kCalled; ++i) {
    for (const Side side : kSides) persons.game.robot(side, 2).position_m.x() += 2.0 / 60;
    persons.game.step();
  }
  EXPECT_EQ(persons.state(), State::kRun);
  EXPECT_NEAR(persons.game.now_s() - call.time_s, 2, 0.1);
}

TEST(BesideAPerson, RobotsThatStopDoNotOverruleTheCall) {
  PersonsGame persons;
  persons.start_play();
  persons.kick_out();
  persons.game.put_ball({0.5, 0});
  for (int i = 0; i < 10 * 60; ++i) {
    for (const Side side : kSides) persons.game.robot(side, 2).position_m.x() += 0.8 / 60;
    persons.game.step();
  }
  EXPECT_EQ(persons.state(), State::kCalled);
}

TEST(BesideAPerson, AnExitAfterACallThatNobodyAnsweredIsCalledToo) {
  Configuration configuration = commanded_by_person();
  configuration.rules = *find_rule_book("2014");
  ScriptedGame game(configuration);
  game.placement_works = false;
  game.line_up().run(0.1);
  Person person(game);
  person.gives(CommandKind::kForceStart);
  game.run(0.5);
  game.kick_from(Side::kWest, 1, {0.5, 0}, {0, 9.5});  // too fast
  const Decision foul = game.run_until("bot_kicked_ball_too_fast", 1);
  EXPECT_EQ(foul.to, State::kCalled);
  const Decision exit = game.run_until("throw_in", 1);
  EXPECT_EQ(exit.to, State::kCalled);
  EXPECT_EQ(game.count("overruled"), 1);
}

TEST(BesideAPerson, ABallThatAppearsElsewhereHasNoHistory) {
  PersonsGame persons;
  persons.start_play();
  persons.game.kick_from(Side::kWest, 1, {0.5, 0.5}, {0, 1});
  persons.game.run(0.2);
  persons.game.put_ball({-1.5, -1.5});  // two metres away
  persons.game.ball_mps = Vec2(0, -1);
  persons.game.run_until("touch_line_unknown", 3);
}

TEST(BesideAPerson, ASingleFalseBallChangesNothing) {
  PersonsGame persons;
  persons.start_play();
  persons.game.kick_from(Side::kWest, 1, {0.5, 0.5}, {0, 2});
  persons.game.run(0.2);
  const Vec2 ball_m = persons.game.frame.ball->position_m;
  const Vec2 ball_mps = persons.game.ball_mps;
  persons.game.put_ball({-1.5, -1.5});
  persons.game.step();
  persons.game.put_ball(ball_m);
  persons.game.ball_mps = ball_mps;
  persons.game.run_until("throw_in", 2);
}

TEST(BesideAPerson, PlayIsJoinedInTheMiddleWithoutAHistory) {
  ScriptedGame game(commanded_by_person());
  game.placement_works = false;
  game.line_up();
  RefereeSignal given;
  given.command = {CommandKind::kDirectFree, Side::kEast};
  given.command_counter = 17;
  game.referee.follow(given);  // before the first frame
  game.put_ball({0.5, 1.2});
  game.ball_mps = Vec2(0, 2);
  game.step();
  EXPECT_EQ(game.referee.state(), State::kRun);
  EXPECT_TRUE(game.referee.is_ball_in_play());
  const Decision exit = game.run_until("touch_line_unknown", 2);
  EXPECT_FALSE(exit.last_touch.side);
}

TEST(BesideAPerson, NothingIsInferredAcrossAGap) {
  PersonsGame persons;
  persons.start_play();
  persons.game.kick_from(Side::kWest, 1, {0.5, 0.5}, {0, 2});
  persons.game.run(0.4);
  ASSERT_EQ(persons.state(), State::kRun);
  const double speed_mps = persons.game.ball_mps.y();
  persons.game.ball_mps = Vec2(0, 0);
  persons.game.skip(5);
  persons.game.put_ball({-1, 1.2});
  persons.game.ball_mps = Vec2(0, speed_mps);
  persons.game.run_until("touch_line_unknown", 2);
}

TEST(BesideAPerson, NoCardIsShown) {
  Configuration configuration = commanded_by_person();
  configuration.rules = *find_rule_book("2026-b");
  ScriptedGame game(configuration);
  game.line_up().run(0.1);
  Person person(game);
  person.gives(CommandKind::kStop);
  for (int i = 0; i < 60 * 20; ++i) {  // a yellow robot drives to and fro at 2.4 m/s
    game.robot(Side::kWest, 1).position_m.x() += (i / 30 % 2 == 0 ? 1 : -1) * 0.04;
    game.step();
  }
  EXPECT_GT(game.count("bot_too_fast_in_stop"), 0);
  EXPECT_EQ(game.count("multiple_fouls"), 0);
  EXPECT_EQ(game.signal.yellow_cards[Side::kWest], 0);
}

// "A goal is awarded if the defending team commits any foul" (2026, Penalty Kick); play goes on.
TEST(BesideAPerson, AFoulByTheDefendersAtAPenaltyKickIsAGoal) {
  Configuration configuration = commanded_by_person();
  configuration.rules = *find_rule_book("2026-b");
  ScriptedGame game(configuration);
  game.placement_works = false;
  game.line_up().run(0.1);
  Person person(game);
  const Vec2 mark_m = configuration.field.penalty_mark_at(Side::kEast);
  game.put_ball(mark_m);
  game.robot(Side::kWest, 1).position_m = mark_m - Vec2(kFrontDistance_m + kBallRadius_m, 0);
  person.gives(CommandKind::kPreparePenalty, Side::kWest);
  game.run(0.5);
  person.gives(CommandKind::kNormalStart);
  game.robot(Side::kWest, 2).position_m = {-2, 0};
  for (int i = 0; i < ScriptedGame::kRate_hz && game.count("goal") == 0; ++i) {
    game.robot(Side::kEast, 2).position_m = {-2, 2.5 - i * 2.5 / ScriptedGame::kRate_hz};
    game.step();
  }
  EXPECT_EQ(game.count("bot_crash_unique"), 1);
  ASSERT_EQ(game.count("goal"), 1);
  const Decision& goal = game.decisions.back();
  EXPECT_EQ(goal.from, State::kRun);
  EXPECT_EQ(goal.to, State::kCalled);
  EXPECT_EQ(goal.finding.restart.side, Side::kEast);
}

}  // namespace
}  // namespace autoref::referee
