#include "game/team_programs/program_games.hpp"

#include <unistd.h>

#include <utility>

#include "game/loop/game.hpp"
#include "game/team_programs/program_team.hpp"

namespace autoref::game {
namespace {

// Records another team's commands and requests.
class RecordedTeam final : public strategies::Strategy {
 public:
  RecordedTeam(std::unique_ptr<strategies::Strategy> team, char letter, CommandsWriter& file,
               bool& was_killed)
      : team_(std::move(team)), letter_(letter), file_(&file), was_killed_(&was_killed) {}

  bool has_sensors() const override { return team_->has_sensors(); }
  void sense(const strategies::SensorReadings& readings) override { team_->sense(readings); }
  void prepare(const TeamView& view) override { team_->prepare(view); }
  TeamRequests requests() const override { return entry_.requests; }
  void end(const strategies::GameEnd& end) override { team_->end(end); }

  void decide(const TeamView& view, TeamCommands& commands) override {
    try {
      team_->decide(view, commands);
    } catch (const strategies::StrategyFault& fault) {
      entry_.fault = fault.what();
      *was_killed_ = *was_killed_ || dynamic_cast<const ProgramKilled*>(&fault) != nullptr;
      file_->add(letter_, entry_);
      throw;
    }
    entry_.commands = commands;
    entry_.requests = team_->requests();
    file_->add(letter_, entry_);
  }

 private:
  std::unique_ptr<strategies::Strategy> team_;
  char letter_;
  CommandsWriter* file_;
  bool* was_killed_;
  TeamEntry entry_;
};

// Compares another team's commands and requests with a file.
class ComparedTeam final : public strategies::Strategy {
 public:
  ComparedTeam(std::unique_ptr<strategies::Strategy> team, char letter, CommandsReader& file,
               bool& is_equal, bool& was_killed)
      : team_(std::move(team)),
        letter_(letter),
        file_(&file),
        is_equal_(&is_equal),
        was_killed_(&was_killed) {}

  bool has_sensors() const override { return team_->has_sensors(); }
  void sense(const strategies::SensorReadings& readings) override { team_->sense(readings); }
  void prepare(const TeamView& view) override { team_->prepare(view); }
  TeamRequests requests() const override { return team_->requests(); }

  void decide(const TeamView& view, TeamCommands& commands) override {
    try {
      team_->decide(view, commands);
    } catch (const ProgramKilled&) {
      *was_killed_ = true;
      throw;
    }
    const TeamEntry& entry = file_->next(letter_);
    if (!entry.fault.empty() || !is_same(entry, {commands, team_->requests(), {}}))
      *is_equal_ = false;
  }

 private:
  std::unique_ptr<strategies::Strategy> team_;
  char letter_;
  CommandsReader* file_;
  bool* is_equal_;
  bool* was_killed_;
};

// Plays back the commands in a file.
class ReplayedTeam final : public strategies::Strategy {
 public:
  ReplayedTeam(char letter, CommandsReader& file) : letter_(letter), file_(&file) {}

  void decide(const TeamView& /*view*/, TeamCommands& commands) override {
    const TeamEntry& entry = file_->next(letter_);
    requests_ = entry.requests;
    if (!entry.fault.empty()) throw strategies::StrategyFault(entry.fault);
    commands = entry.commands;
  }
  TeamRequests requests() const override { return requests_; }

 private:
  char letter_;
  CommandsReader* file_;
  TeamRequests requests_;
};

}  // namespace

ProgramSpec spec_of(const TeamProgram& program) {
  ProgramSpec spec;
  spec.command = program.command;
  spec.directory = program.directory;
  spec.environment = program.environment;
  spec.limits.answer_s = program.answer_s;
  spec.limits.memory_bytes = static_cast<std::uint64_t>(program.memory_mb) << 20U;
  return spec;
}

namespace {

bool is_foreign(const TeamConfiguration& team) { return team.program || team.on_network; }

}  // namespace

bool has_programs(const GameConfiguration& game) {
  return is_foreign(game.a) || is_foreign(game.b);
}

std::unique_ptr<strategies::Strategy> make_program_or_registered_team(
    const TeamConfiguration& team, const strategies::TeamContext& context) {
  if (!team.program) return make_registered_team(team, context);
  return std::make_unique<ProgramTeam>(spec_of(*team.program), context);
}

GamePrograms GamePrograms::live(const GameConfiguration& game, ProgramFiles files,
                                TeamMaker make_network_team) {
  GamePrograms programs;
  programs.make_network_team_ = std::move(make_network_team);
  programs.side_a_ = game.match.a_plays;
  if (has_programs(game) && !files.commands.empty())
    programs.writer_ = std::make_unique<CommandsWriter>(files.commands, files.commands_kind);
  programs.files_ = std::move(files);
  return programs;
}

GamePrograms GamePrograms::recorded(const GameConfiguration& game,
                                    const std::filesystem::path& commands, io::FileKind kind) {
  GamePrograms programs;
  programs.side_a_ = game.match.a_plays;
  programs.reader_ = std::make_unique<CommandsReader>(commands, kind);
  return programs;
}

GameConfiguration GamePrograms::configured(const GameConfiguration& game) {
  GameConfiguration changed = game;
  if (reader_) reader_->change_robots(changed);
  return changed;
}

void GamePrograms::record(const ChangedRobot& changed) {
  if (writer_) writer_->add(changed);
}

TeamMaker GamePrograms::maker() {
  return [this](const TeamConfiguration& team, const strategies::TeamContext& context) {
    return make(team, context);
  };
}

std::unique_ptr<strategies::Strategy> GamePrograms::make(const TeamConfiguration& team,
                                                         const strategies::TeamContext& context) {
  if (!is_foreign(team)) return make_registered_team(team, context);
  const char letter = context.side == side_a_ ? 'a' : 'b';
  if (reader_) return std::make_unique<ReplayedTeam>(letter, *reader_);
  std::unique_ptr<strategies::Strategy> made = make_live(team, context, letter);
  if (!writer_) return made;
  return std::make_unique<RecordedTeam>(std::move(made), letter, *writer_, was_killed_);
}

std::unique_ptr<strategies::Strategy> GamePrograms::make_live(
    const TeamConfiguration& team, const strategies::TeamContext& context, char letter) const {
  if (!team.program) {
    return make_network_team_ ? make_network_team_(team, context)
                              : make_registered_team(team, context);
  }
  ProgramSpec spec = spec_of(*team.program);
  spec.stderr_file = letter == 'a' ? files_.stderr_a : files_.stderr_b;
  if (files_.show_stderr) spec.stderr_copy = STDERR_FILENO;
  return std::make_unique<ProgramTeam>(spec, context);
}

bool GamePrograms::before_step(Game& game) {
  if (!reader_) return true;
  const std::optional<std::vector<WorldChange>> changes = reader_->read_step();
  if (!changes) return false;
  for (const WorldChange& change : *changes) apply(change, game);
  return true;
}

void GamePrograms::change(const WorldChange& change, Game& game) {
  apply(change, game);
  if (writer_) writer_->add(change);
}

bool GamePrograms::finish(const GameRecord& record, bool is_interrupted) {
  if (writer_) std::exchange(writer_, nullptr)->close(record.state_hash, is_interrupted);
  if (!reader_ || is_truncated()) return true;
  return reader_->final_state().value_or(record.state_hash) == record.state_hash;
}

std::optional<bool> repeats(const GameConfiguration& game, const std::filesystem::path& commands,
                            double seconds) {
  CommandsReader reader(commands);
  bool is_equal = true;
  bool was_killed = false;
  Game again(game, nullptr, [&](const TeamConfiguration& team, const strategies::TeamContext& c) {
    std::unique_ptr<strategies::Strategy> made = make_program_or_registered_team(team, c);
    if (!team.program) return made;
    const char letter = c.side == game.match.a_plays ? 'a' : 'b';
    made = std::make_unique<ComparedTeam>(std::move(made), letter, reader, is_equal, was_killed);
    return made;
  });
  for (int frames = static_cast<int>(seconds * game.sim.frame_rate_hz); frames > 0; --frames) {
    if (!again.step() || !is_equal) break;
  }
  if (was_killed) return std::nullopt;
  return is_equal && again.record().status == Status::kOk;
}

}  // namespace autoref::game
