// Games in which teams are programs.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>

#include "game/loop/game_configuration.hpp"
#include "game/loop/game_record.hpp"
#include "game/loop/observer.hpp"
#include "game/loop/team_controller.hpp"
#include "game/team_programs/commands_file.hpp"
#include "game/team_programs/program_spec.hpp"

namespace autoref::game {

// Whether a team is a program, or plays over the network: its commands can be recorded.
bool has_programs(const GameConfiguration& game);

// How to start it.
ProgramSpec spec_of(const TeamProgram& program);

// The team's program (program_team.hpp) if it has one, else the registered strategy. Throws like
// make_registered_team().
std::unique_ptr<strategies::Strategy> make_program_or_registered_team(
    const TeamConfiguration& team, const strategies::TeamContext& context);

// Files that a game's programs leave. Empty paths: none.
struct ProgramFiles {
  std::filesystem::path commands;       // commands_file.hpp
  std::filesystem::path stderr_a = {};  // standard error of team a's program
  std::filesystem::path stderr_b = {};
  bool show_stderr = false;  // also on AutoRef's
  io::FileKind commands_kind = io::FileKind::kFile;
};

// Plays a game's programs, or their recorded commands, and keeps its files.
class GamePrograms {
 public:
  // Plays the programs. Throws InputOutputError if a file cannot be written.
  // `make_network_team` makes teams that play over the network; without it, games with them
  // cannot be played.
  static GamePrograms live(const GameConfiguration& game, ProgramFiles files,
                           TeamMaker make_network_team = {});
  // Plays the commands of a file instead of the programs. Throws InputError, InputOutputError.
  static GamePrograms recorded(const GameConfiguration& game, const std::filesystem::path& commands,
                               io::FileKind kind = io::FileKind::kFile);

  // The game with the robots that were changed before it began, if it is played from recorded
  // commands. Throws as CommandsReader.
  GameConfiguration configured(const GameConfiguration& game);
  // Records that a robot was changed before the game. Throws as CommandsWriter.
  void record(const ChangedRobot& changed);

  // For Game; this object must outlive its teams.
  TeamMaker maker();

  // Call it before each step: plays the recorded changes of the world. Throws as CommandsReader.
  void before_step(Game& game);
  // Changes the world between two steps, and records that. Throws as CommandsWriter.
  void change(const WorldChange& change, Game& game);

  // Whether a program whose commands are recorded was killed from outside.
  bool was_killed() const { return was_killed_; }

  // Call it with the final record: completes the file of commands. If the game was played from
  // recorded commands, returns whether it ended in the recorded state. Throws as CommandsWriter and
  // CommandsReader do.
  bool finish(const GameRecord& record);

 private:
  std::unique_ptr<strategies::Strategy> make(const TeamConfiguration& team,
                                             const strategies::TeamContext& context);

  std::unique_ptr<strategies::Strategy> make_live(const TeamConfiguration& team,
                                                  const strategies::TeamContext& context,
                                                  char letter) const;

  TeamMaker make_network_team_;
  Side side_a_ = Side::kWest;
  ProgramFiles files_;
  bool was_killed_ = false;
  std::unique_ptr<CommandsWriter> writer_;  // null: nothing is recorded
  std::unique_ptr<CommandsReader> reader_;  // null: the programs play
};

// Starts the programs again and plays the first `seconds` of a game that was recorded. Returns
// whether they send the recorded commands; nullopt if one was killed from outside.
std::optional<bool> repeats(const GameConfiguration& game, const std::filesystem::path& commands,
                            double seconds);

}  // namespace autoref::game
