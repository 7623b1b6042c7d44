// The beginners' teams, one algorithm in several languages: each plays the same games, bit for bit,
// as the one in C++ compiled in.
#include "game/team_programs/team_templates.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "game/loop/game.hpp"
#include "game/settings/fields.hpp"
#include "game/settings/game_settings.hpp"
#include "game/team_programs/program_games.hpp"
#include "soccer/geometry.hpp"
#include "soccer/robot_shape.hpp"
#include "tests/support/temporary_folder.hpp"

#define main beginners_main
namespace beginner {
#include "game/team_programs/templates/cpp/my_team.cpp"
}  // namespace beginner
#undef main

namespace autoref::game {
namespace {

namespace fs = std::filesystem;

beginner::Point point_of(const Vec2& v) { return {v.x(), v.y()}; }

// The team in C++, compiled in. Its commands reach the robots like a program's.
class CompiledBeginner final : public strategies::Strategy {
 public:
  explicit CompiledBeginner(const Field& field)
      : pitch_{field.length_m, field.width_m, field.defence_area.depth_m,
               field.defence_area.straight_m,
               field.defence_area.shape == DefenceArea::Shape::kBox} {}

  void decide(const TeamView& view, TeamCommands& commands) override {
    beginner::Sight sight{view.frame,
                          view.latency_s,
                          static_cast<int>(view.play),
                          view.ours,
                          point_of(view.ball.position_m),
                          point_of(view.ball.velocity_mps),
                          view.placement_m.has_value(),
                          point_of(view.placement_m.value_or(Vec2(0, 0))),
                          {}};
    for (const TrackedRobot& robot : view.own) {
      sight.own.push_back({robot.number, point_of(robot.position_m), point_of(robot.heading),
                           point_of(robot.velocity_mps)});
    }
    const std::vector<beginner::Order> orders = beginner::decide(sight, pitch_);
    for (const beginner::Order& order : orders) {
      commands[static_cast<std::size_t>(order.robot)] =
          transmitted({Vec2(order.forward, order.left), order.turn, beginner::kKick_mps});
    }
    requests_.keeper = orders.empty() ? 0 : orders[0].robot;
  }
  TeamRequests requests() const override { return requests_; }

 private:
  beginner::Pitch pitch_;
  TeamRequests requests_;
};

struct Language {
  std::string name;
  std::string build;  // in the team's folder; empty: none
  std::vector<std::string> command;
};

std::string language_name(const testing::TestParamInfo<Language>& info) { return info.param.name; }

bool runs(const std::string& command) {
  return std::system((command + " >/dev/null 2>&1").c_str()) == 0;
}

// Games that differ in rules, side, noise, opponent and size.
GameSettings game_of_template(int number) {
  GameSettings game;
  choose_rules(number % 2 == 0 ? "2014" : "2026-b", game);
  game.match.half_s = 2;
  game.seed = static_cast<std::uint64_t>(number);
  set_by_path(game, "sim.camera", number % 3 == 0 ? "none" : "realistic");
  set_by_path(game, "b.strategy", number % 3 == 1 ? "dummy" : "basic");
  set_by_path(game, "match.a_plays", number % 4 < 2 ? "west" : "east");
  if (number == 3) set_by_path(game, "a.robots", "3");
  if (number == 4) set_by_path(game, "a.robots", "1");
  return game;
}

TeamMaker beginner_as_a(const GameSettings& game) {
  return [side_a = game.match.a_plays](
             const TeamConfiguration& team,
             const strategies::TeamContext& context) -> std::unique_ptr<strategies::Strategy> {
    if (context.side != side_a) return make_registered_team(team, context);
    return std::make_unique<CompiledBeginner>(context.field);
  };
}

class TeamTemplates : public testing::TestWithParam<Language> {
 protected:
  TeamTemplates() {
    for (const TemplateFile& file : template_files()) {
      if (file.language == GetParam().name)
        std::ofstream(folder_.path() / file.name) << file.content;
    }
  }

  GameConfiguration with_program(GameSettings game) const {
    game.a.program.command = GetParam().command;
    game.a.program.directory = folder_.path();
    game.a.program.answer_s = 120;  // however long it takes to start on a busy machine
    return resolved(game);
  }

  TemporaryFolder folder_;
};

TEST_P(TeamTemplates, PlayTheSameGamesAsCompiledIn) {
  const Language& language = GetParam();
  const std::string tool = language.build.substr(0, language.build.find(' '));
  const std::string needed = tool.empty() ? language.command[0] : tool;
  if (!runs("command -v " + needed)) {
    GTEST_SKIP() << "skipped: missing Debian packages: " << (needed == "node" ? "nodejs" : needed)
                 << " (scripts/setup --checks installs them)";
  }
  ASSERT_TRUE(language.build.empty() ||
              runs("cd " + folder_.path().string() + " && " + language.build));
  for (int number = 1; number <= 20; ++number) {
    const GameSettings settings = game_of_template(number);
    const GameRecord compiled = play(resolved(settings), nullptr, beginner_as_a(settings));
    const GameRecord program =
        play(with_program(settings), nullptr, make_program_or_registered_team);
    EXPECT_EQ(program.status, Status::kOk) << program.void_reason;
    EXPECT_EQ(program.state_hash, compiled.state_hash) << "game " << number;
  }
}

// A team's interferences with the placement of the ball.
class InterferenceCount final : public Observer {
 public:
  explicit InterferenceCount(Side side) : side_(side) {}
  void on_decision(const referee::Decision& decision) override {
    const referee::Finding& finding = decision.finding;
    if (finding.event == referee::Event::kBotInterferedPlacement && finding.offender == side_)
      ++count;
  }
  int count = 0;

 private:
  Side side_;
};

// Games as `autoref team play` plays them. All languages play the same ones, as tested above.
TEST(TeamTemplate, HardlyEverInterferesWithBallPlacement) {
  int all = 0;
  for (const char* opponent : {"dummy", "basic", "cobalt"}) {
    for (const char* placement : {"simulator", "teams"}) {
      GameSettings game;
      choose_rules("2026-b", game);
      game.match.half_s = 60;
      set_by_path(game, "b.strategy", opponent);
      set_by_path(game, "match.placement", placement);
      InterferenceCount interferences(game.match.a_plays);
      const GameRecord record = play(resolved(game), &interferences, beginner_as_a(game));
      EXPECT_EQ(record.status, Status::kOk) << record.void_reason;
      EXPECT_LE(interferences.count, 2) << opponent << ", placed by " << placement;
      all += interferences.count;
    }
  }
  EXPECT_LE(all, 3) << "in six games";
}

// After a goal at the other end all robots stand on the ball's way to the centre. The rules want
// them 0.5 m away after 2 s, also on the way home.
TEST(TeamTemplate, LeavesTheBallsWayWithinTwoSeconds) {
  const Vec2 ball_m(4.55, 0.1);
  const Vec2 target_m(0, 0);
  const beginner::Pitch pitch{9, 6, 1, 2, true};
  beginner::Sight sight;
  sight.play = beginner::kStop;
  sight.ball = point_of(ball_m);
  sight.is_placed = true;
  sight.placement = point_of(target_m);
  for (int i = 0; i < 6; ++i) sight.own.push_back({i, {0.6 * i + 0.5, 0.05 * i}, {1, 0}, {0, 0}});
  for (int frame = 0; frame < 600; ++frame) {
    for (const beginner::Order& order : beginner::decide(sight, pitch)) {
      beginner::Player& robot = sight.own[static_cast<std::size_t>(order.robot)];
      robot.at.x += order.forward / 60;
      robot.at.y += order.left / 60;
      if (frame >= 120) {
        const double gap_m =
            distance_to_segment(Vec2(robot.at.x, robot.at.y), ball_m, target_m) - kRobotRadius_m;
        ASSERT_GE(gap_m, 0.5) << "robot " << order.robot << " in frame " << frame;
      }
    }
  }
  for (const beginner::Player& robot : sight.own) EXPECT_LT(robot.at.x, 0) << robot.number;
}

// Languages that only few machines have are left out where they are missing.
std::vector<Language> languages() {
  std::vector<Language> all = {
      Language{"python", "", {"python3", "my_team.py"}},
      Language{"javascript", "", {"node", "my_team.js"}},
      Language{"c", "cc -O2 -ffp-contract=off -o my_team my_team.c -lm", {"./my_team"}},
      Language{"cpp", "c++ -std=c++17 -O2 -ffp-contract=off -o my_team my_team.cpp", {"./my_team"}},
      Language{"rust", "rustc --edition 2021 -O -o my_team my_team.rs", {"./my_team"}},
      Language{"go", "go build -o my_team my_team.go", {"./my_team"}}};
  std::erase_if(all, [](const Language& language) {
    return (language.name == "go" && !runs("command -v go")) ||
           (language.name == "rust" && !runs("command -v rustc"));
  });
  return all;
}

INSTANTIATE_TEST_SUITE_P(Languages, TeamTemplates, testing::ValuesIn(languages()), language_name);

}  // namespace
}  // namespace autoref::game
