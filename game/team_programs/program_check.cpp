#include "game/team_programs/program_check.hpp"

#include <algorithm>
#include <bitset>
#include <chrono>
#include <memory>
#include <utility>

#include "game/loop/game.hpp"
#include "game/team_programs/commands_file.hpp"
#include "game/team_programs/program_games.hpp"
#include "game/team_programs/program_team.hpp"
#include "league/team/greeting.hpp"

namespace autoref::game {
namespace {

using CheckClock = std::chrono::steady_clock;

double ms_since(CheckClock::time_point then) {
  return std::chrono::duration<double, std::milli>(CheckClock::now() - then).count();
}

bool does_anything(const RobotCommand& c) {
  return c.velocity_mps != Vec2(0, 0) || c.angular_velocity_radps != 0 || c.kick_mps != 0 ||
         c.dribble;
}

// The program's answers in its first run, which it must repeat in the second.
struct SeenAnswers {
  TeamCheck check;
  std::bitset<kMaxRobots> commanded;
  std::vector<TeamEntry> entries;
  bool is_repeated = true;
};

// Observes a program in its first run.
class CheckedTeam final : public strategies::Strategy {
 public:
  CheckedTeam(std::unique_ptr<ProgramTeam> team, SeenAnswers& seen)
      : team_(std::move(team)), seen_(&seen), began_(CheckClock::now()) {}

  bool has_sensors() const override { return true; }
  void sense(const strategies::SensorReadings& readings) override { team_->sense(readings); }
  TeamRequests requests() const override { return team_->requests(); }

  void prepare(const TeamView& view) override {
    if (!seen_->entries.empty()) began_ = CheckClock::now();
    team_->prepare(view);
    seen_->check.greeting = team_->greeting();
  }

  void decide(const TeamView& view, TeamCommands& commands) override {
    team_->decide(view, commands);
    const double took_ms = ms_since(began_);
    if (seen_->entries.empty()) {
      seen_->check.start_ms = took_ms;
    } else {
      seen_->check.answers_ms.push_back(took_ms);
    }
    note(commands);
  }

  void end(const strategies::GameEnd& end) override {
    team_->end(end);
    seen_->check.ending = team_->ending();
  }

 private:
  void note(const TeamCommands& commands) {
    for (std::size_t i = 0; i < commands.size(); ++i)
      seen_->commanded[i] = seen_->commanded[i] || does_anything(commands[i]);
    seen_->check.keeper = team_->requests().keeper;
    seen_->check.asked_for_timeout = seen_->check.asked_for_timeout || team_->requests().timeout;
    seen_->entries.push_back({commands, team_->requests(), {}});
  }

  std::unique_ptr<ProgramTeam> team_;
  SeenAnswers* seen_;
  CheckClock::time_point began_;
};

// Compares a program's second run with its first.
class RepeatingTeam final : public strategies::Strategy {
 public:
  RepeatingTeam(std::unique_ptr<ProgramTeam> team, SeenAnswers& seen)
      : team_(std::move(team)), seen_(&seen) {}

  bool has_sensors() const override { return true; }
  void sense(const strategies::SensorReadings& readings) override { team_->sense(readings); }
  void prepare(const TeamView& view) override { team_->prepare(view); }
  TeamRequests requests() const override { return team_->requests(); }

  void decide(const TeamView& view, TeamCommands& commands) override {
    team_->decide(view, commands);
    const TeamEntry now{commands, team_->requests(), {}};
    if (frame_ >= seen_->entries.size() || !is_same(now, seen_->entries[frame_]))
      seen_->is_repeated = false;
    ++frame_;
  }

 private:
  std::unique_ptr<ProgramTeam> team_;
  SeenAnswers* seen_;
  std::size_t frame_ = 0;
};

// Plays a game in which team a is a `Watcher` of its program.
template <typename Watcher>
GameRecord play_watched(const GameConfiguration& game, SeenAnswers& seen) {
  return play(
      game, nullptr,
      [&seen](const TeamConfiguration& team,
              const strategies::TeamContext& context) -> std::unique_ptr<strategies::Strategy> {
        if (!team.program) return make_registered_team(team, context);
        auto program = std::make_unique<ProgramTeam>(spec_of(*team.program), context);
        return std::make_unique<Watcher>(std::move(program), seen);
      });
}

}  // namespace

TeamCheck check_team(const GameConfiguration& game) {
  SeenAnswers seen;
  const GameRecord record = play_watched<CheckedTeam>(game, seen);
  seen.check.played_s = record.sim_s;
  seen.check.robots_commanded = static_cast<int>(seen.commanded.count());
  std::sort(seen.check.answers_ms.begin(), seen.check.answers_ms.end());
  seen.check.fault = record.void_reason;
  if (!seen.check.fault.empty()) return seen.check;
  const GameRecord again = play_watched<RepeatingTeam>(game, seen);
  seen.check.is_repeatable = seen.is_repeated && again.void_reason.empty();
  return seen.check;
}

}  // namespace autoref::game
