// Logs by other programs: whatever a valid log contains or lacks, it can be refereed and shown, and
// any value used instead is reported once.
#include <gtest/gtest.h>

#include "io/errors.hpp"
#include "league/referee_message.hpp"
#include "soccer/referee_signal.hpp"
#include "tests/app/answer.hpp"
#include "tests/checkout.hpp"
#include "tests/logs/sketched_log.hpp"
#include "tests/support/temporary_folder.hpp"

namespace autoref::logs {
namespace {

int detections_of(const std::string& what, const std::string& text) {
  int count = 0;
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1))
    ++count;
  return count;
}

class ForeignLog : public testing::Test {
 protected:
  void write(const SketchedLog& sketch) { write_sketch(sketch, log_); }

  app::Answer referee(std::vector<const char*> more = {}) const { return run("referee log", more); }
  app::Answer run(const char* verb, const std::vector<const char*>& more) const {
    std::vector<const char*> arguments = {log_.c_str()};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return app::answer_to(verb, arguments);
  }

  // Checks that every verb that reads logs accepts the log, and that the referee reports `said`
  // once.
  void expect_judged(const std::string& said = "", const char* control = nullptr) const {
    const app::Answer answer = control == nullptr ? referee() : referee({"--control", control});
    EXPECT_EQ(answer.code, io::kDone) << answer.err;
    EXPECT_NE(answer.out.find("by AutoRef"), std::string::npos) << answer.out;
    if (!said.empty()) {
      EXPECT_EQ(detections_of(said, answer.err), 1) << answer.err;
    }
    expect_shown();
  }
  void expect_shown() const {
    const std::string page = folder_ / "game.html";
    const std::string drawing = folder_ / "frame.svg";
    EXPECT_EQ(run("log info", {}).code, io::kDone);
    const app::Answer viewed = run("view", {"-o", page.c_str()});
    EXPECT_EQ(viewed.code, io::kDone) << viewed.err;
    const app::Answer drawn = run("log draw", {"--at", "1", "-o", drawing.c_str()});
    EXPECT_EQ(drawn.code, io::kDone) << drawn.err;
  }

  TemporaryFolder folder_;
  std::string log_ = folder_ / "game.log";
};

TEST_F(ForeignLog, WithTheLeaguesMarginOf300MillimetresIsJudged) {
  write({.change_field = [](league::FieldSize& size) { size.set_boundary_width(300); }});
  expect_judged();
  write({.change_field = [](league::FieldSize& size) { size.set_boundary_width(0); }});
  expect_judged();
  write({.change_field = [](league::FieldSize& size) {
    size.set_boundary_width(300);
    size.set_boundary_width_goal_line(600);
    size.set_goal_substitution_area_width(1000);
  }});
  expect_judged();
}

TEST_F(ForeignLog, WithoutTheStagesClockIsJudgedWithTheBooksHalf) {
  write({.change_referee = [](double, league::RefereePacket& packet) {
    packet.clear_stage_time_left();
  }});
  expect_judged(
      "the clock of the first half is missing: using halves of 600 s (change with --set "
      "match.half_s=",
      "autoref");
  EXPECT_EQ(referee().err.find("the clock"), std::string::npos)
      << "the recorded referee keeps time";
  const app::Answer set = referee({"--control", "autoref", "--set", "match.half_s=300"});
  EXPECT_EQ(set.err.find("the clock"), std::string::npos);
  const app::Answer of_book = referee({"--control", "autoref", "--rules", "2026-b"});
  EXPECT_EQ(detections_of("halves of 300 s", of_book.err), 1);
}

TEST_F(ForeignLog, InOvertimeIsJudged) {
  write({.change_referee = [](double, league::RefereePacket& packet) {
    packet.set_stage_time_left(-5'000'000);
  }});
  expect_judged("the clock of the first half is missing", "autoref");
}

TEST_F(ForeignLog, WithoutGeometryIsJudgedOnTheBooksField) {
  write({.has_geometry = false});
  expect_judged("no geometry: using the field of the rules paper, 6.05 x 4.05 m");
  EXPECT_EQ(detections_of("9 x 6 m", referee({"--rules", "2026-b"}).err), 1);
  const std::string page = folder_ / "game.html";
  const app::Answer viewed = run("view", {"-o", page.c_str(), "--rules", "2026-b"});
  EXPECT_EQ(detections_of("using the field of the rules 2026-b", viewed.err), 1) << viewed.err;
  EXPECT_NE(content_of(page).find("\"halfLength_mm\": 4500"), std::string::npos);
  EXPECT_EQ(run("view", {"-o", page.c_str(), "--rules", "2027"}).code, io::kBadInput);
}

TEST_F(ForeignLog, IsJudgedByTheRulesThatItsFieldAndDateSuggest) {
  write({.field = find_game_setup("2026-b")->field,
         .record_s = [](double time_s) { return 1.783e9 + time_s; }});
  expect_judged("9 x 6 m, recorded on 2026-07-02: using the rules 2026-b (change with --rules)");
  EXPECT_EQ(detections_of("using the rules", referee({"--rules", "2014"}).err), 0);
}

TEST_F(ForeignLog, WithoutAreasAndMarksUsesThoseOfTheRuleBook) {
  write({.change_field = [](league::FieldSize& size) {
    size.clear_field_lines();
    size.clear_field_arcs();
    size.clear_goal_center_to_penalty_mark();
  }});
  expect_judged("the geometry has no defence areas: using a depth of 0.8 m");
  EXPECT_EQ(detections_of("no penalty mark: using 6 m from", referee({"--rules", "2026-b"}).err),
            1);
}

TEST_F(ForeignLog, WithChangingGeometryIsJudgedOnTheLastField) {
  write({.change_field_later = [](league::FieldSize& size) { size.set_field_length(9000); }});
  expect_judged("the field changes 1 times; using the last field");
  EXPECT_NE(run("log info", {}).out.find("field     9 x 4.05 m"), std::string::npos);
}

TEST_F(ForeignLog, WithoutARefereeIsJudged) {
  write({.has_referee = false});
  expect_judged("no referee packets: assuming that play is on throughout");
  const app::Answer alone = referee({"--control", "autoref"});
  EXPECT_EQ(detections_of("the first kick-off is missing: giving it to west", alone.err), 1);
  const app::Answer set = referee({"--control", "autoref", "--first-kickoff", "east"});
  EXPECT_EQ(detections_of("kick-off", set.err), 0);
}

TEST_F(ForeignLog, WithoutRobotsOfOneTeamIsJudged) {
  write({.robots = {{6, 0}}});
  expect_judged("robots of the blue team are never detected");
}

TEST_F(ForeignLog, WithUnknownStagesAndCommandsIsJudged) {
  write({.change_referee = [](double time_s, league::RefereePacket& packet) {
    if (time_s > 3) packet.set_stage(14);
    if (time_s > 2 && time_s <= 3) packet.set_command(99);
  }});
  expect_judged("referee packets have an unknown stage or command and are ignored");
}

TEST_F(ForeignLog, WithRobotsNumberedBeyond15IsJudgedWithoutThem) {
  write({.change_detection = [](league::DetectionFrame& detection) {
    for (auto& robot : *detection.mutable_robots_blue()) robot.set_robot_id(robot.robot_id() + 14);
  }});
  expect_judged("detections of robots with numbers from 16 are ignored");
}

TEST_F(ForeignLog, StartingInTheMiddleOfPlayIsReported) {
  write({.change_referee = [](double, league::RefereePacket& packet) {
    packet.set_stage(static_cast<int>(Stage::kFirstHalf));
    packet.set_command(league_number({CommandKind::kForceStart}));
    packet.set_command_counter(1);
  }});
  expect_judged("the log starts in the middle of play (FORCE_START)", "autoref");
  EXPECT_EQ(referee().err.find("middle of play"), std::string::npos) << "AutoRef joins it";
  write({});
  EXPECT_EQ(referee({"--control", "autoref"}).err.find("middle of play"), std::string::npos);
}

TEST_F(ForeignLog, OfOneCameraIsJudged) {
  write({.cameras = 1});
  expect_judged();
}

TEST_F(ForeignLog, OfDivisionAAndOfHalfAFieldIsJudged) {
  const Field division_a = find_game_setup("2026-a")->field;
  write({.field = division_a, .robots = {{11, 11}}});
  expect_judged();
  Field half = division_a;
  half.length_m /= 2;
  write({.field = half});
  expect_judged();
}

TEST_F(ForeignLog, WithAnImpossibleFieldIsRefusedNamingTheSetting) {
  write({.change_field = [](league::FieldSize& size) { size.set_field_length(100); }});
  const app::Answer answer = referee();
  EXPECT_EQ(answer.code, io::kBadInput);
  EXPECT_NE(answer.err.find("cannot be refereed: field.length_m is 0.1; it must be from 4 to 30; "
                            "use --set to change it"),
            std::string::npos)
      << answer.err;
  EXPECT_EQ(referee({"--set", "field.length_m=6.05"}).code, io::kDone);
  expect_shown();
}

TEST_F(ForeignLog, WithARestartingCameraClockIsJudgedThroughout) {
  write({.length_s = 20, .capture_s = [](double time_s) {
           return time_s < 5 ? 1.5e9 + time_s : time_s < 10 ? time_s - 5 : 3e9 + time_s;
         }});
  expect_judged("the cameras' clock restarts 2 times");
  const app::Answer info = run("log info", {"--json"});
  EXPECT_NE(info.out.find("\"frames\": 1192"), std::string::npos) << info.out;
}

TEST_F(ForeignLog, LosesOnlyThePacketWithAWrongTime) {
  write({.length_s = 10,
         .capture_s = [](double time_s) { return time_s == 5 ? 4e9 : 1.5e9 + time_s; }});
  expect_judged();
  EXPECT_EQ(referee().err.find("clock restarts"), std::string::npos);
}

TEST_F(ForeignLog, WithRecordsOutOfOrderIsJudged) {
  write({.record_s = [](double time_s) { return 100 - 10 * time_s; }});
  expect_judged();
}

TEST_F(ForeignLog, WithoutABallSaysSo) {
  write({.change_detection = [](league::DetectionFrame& detection) { detection.clear_balls(); }});
  expect_judged("the ball is never detected");
  write({});
  EXPECT_EQ(referee().err.find("never detected"), std::string::npos);
}

TEST_F(ForeignLog, WithoutVisionIsRefused) {
  write({.has_vision = false});
  EXPECT_EQ(run("log info", {}).code, io::kDone);
  const app::Answer answer = referee();
  EXPECT_EQ(answer.code, io::kBadInput);
  EXPECT_NE(answer.err.find("contains neither vision nor tracker packets to referee"),
            std::string::npos);
}

TEST_F(ForeignLog, TakesItsRuleBookByTheFlagThatKeepsItsField) {
  write({});
  const app::Answer answer = referee({"--set", "match.rules=2026-b"});
  EXPECT_EQ(answer.code, io::kBadInput);
  EXPECT_NE(answer.err.find("use --rules to choose the rule book"), std::string::npos)
      << answer.err;
}

// A game recorded by `autoref play`.
class OwnLog : public ForeignLog {
 protected:
  void play(const std::vector<const char*>& settings, const std::string& log) const {
    const std::string game = in_checkout("scenarios/paper-game.yaml");
    std::vector<const char*> arguments = {"play", game.c_str(), "--log", log.c_str()};
    for (const char* setting : settings) arguments.insert(arguments.end(), {"--set", setting});
    const app::Answer answer = app::answer_to(arguments);
    EXPECT_EQ(answer.code, io::kDone) << answer.err;
  }
};

TEST_F(OwnLog, OfAKnockoutGameWithAShootOutIsJudged) {
  const std::string events = folder_ / "events.jsonl";
  for (const char* book : {"match.rules=2014", "match.rules=2026-b"}) {
    play({book, "match.knockout=true", "match.half_s=2", "match.extra_half_s=1", "a.strategy=basic",
          "b.strategy=basic"},
         log_);
    EXPECT_NE(run("log info", {}).out.find("POST_GAME"), std::string::npos) << book;
    expect_judged();
    const app::Answer answer = referee({"--rules", book + std::string("match.rules=").size(),
                                        "--control", "autoref", "--events", events.c_str()});
    EXPECT_EQ(answer.code, io::kDone) << answer.err;
    EXPECT_NE(answer.out.find("F1 1.000"), std::string::npos) << answer.out;
    EXPECT_NE(content_of(events).find("\"shootout_over\""), std::string::npos) << book;
  }
}

TEST_F(OwnLog, OfTwoGamesIsJudgedGameByGame) {
  const std::string one = folder_ / "one.log";
  const std::string two = folder_ / "two.log";
  const std::string events = folder_ / "events.jsonl";
  play({"match.half_s=5"}, one);
  play({"match.half_s=7", "match.first_kickoff=east"}, two);
  join_logs({one, two}, log_);
  expect_judged("the log contains 2 games; the second starts at");
  const app::Answer answer = referee({"--control", "autoref", "--events", events.c_str()});
  EXPECT_NE(answer.out.find("F1 1.000"), std::string::npos) << answer.out;
  EXPECT_EQ(detections_of("\"transition\": \"begin\"", content_of(events)), 2);
}

}  // namespace
}  // namespace autoref::logs
