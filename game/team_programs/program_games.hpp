// Games with team programs.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>

#include "game/loop/game_configuration.hpp"
#include "game/loop/game_record.hpp"
#include "game/loop/observer.hpp"
#include "game/loop/team_controller.hpp"
#include "game/team_programs/commands_reader.hpp"
#include "game/team_programs/commands_writer.hpp"
#include "game/team_programs/program_spec.hpp"

namespace autoref::game {

// Whether a team is a program or plays over the network, so that its commands can be recorded.
bool has_programs(const GameConfiguration& game);

// How to start the program.
ProgramSpec spec_of(const TeamProgram& program);

// Creates the team's program (program_team.hpp) if it has one, otherwise the registered strategy.
// Throws like make_registered_team().
std::unique_ptr<strategies::Strategy> make_program_or_registered_team(
    const TeamConfiguration& team, const strategies::TeamContext& context);

// Files written for a game's programs. If a path is empty, that file is not written.
struct ProgramFiles {
  std::filesystem::path commands;       // commands_file.hpp
  std::filesystem::path stderr_a = {};  // standard error of team a's program
  std::filesystem::path stderr_b = {};
  bool show_stderr = false;  // whether to copy the programs' standard error to AutoRef's
  io::FileKind commands_kind = io::FileKind::kFile;
};

// Runs a game's programs or plays back their recorded commands, and writes the game's files.
class GamePrograms {
 public:
  // Runs the programs. Throws InputOutputError if a file cannot be written. `make_network_team`
  // makes teams that play over the network; without `make_network_team`, games with such teams
  // cannot be played.
  static GamePrograms live(const GameConfiguration& game, ProgramFiles files,
                           TeamMaker make_network_team = {});
  // Plays back the commands in a file instead of running the programs. Throws InputError and
  // InputOutputError.
  static GamePrograms recorded(const GameConfiguration& game, const std::filesystem::path& commands,
                               io::FileKind kind = io::FileKind::kFile);

  // The configuration of `game`. If the game is played from recorded commands, it includes the
  // changes made to robots before the game. Throws like CommandsReader.
  GameConfiguration configured(const GameConfiguration& game);
  // Records the change of a robot before the game. Throws like CommandsWriter.
  void record(const ChangedRobot& changed);

  // The TeamMaker for Game. This object must outlive the teams that it makes.
  TeamMaker maker();

  // Applies the recorded changes of the world. Call this before each step. Returns false if the
  // recorded game was interrupted here (CommandsReader::read_step); then do not step the game.
  // Throws like CommandsReader.
  bool before_step(Game& game);
  // Changes the world between two steps and records the change. Throws like CommandsWriter.
  void change(const WorldChange& change, Game& game);

  // Whether a program was killed from outside while its commands were being recorded.
  bool was_killed() const { return was_killed_; }

  // Completes the file of commands; call this with the final record, or with that of an interrupted
  // game. If the game was played from recorded commands, returns whether it ended in the recorded
  // state, or true if that is unknown (is_truncated()). Throws like CommandsWriter and
  // CommandsReader.
  bool finish(const GameRecord& record, bool is_interrupted = false);

  // Whether the game is played from recorded commands and their file has turned out to be
  // truncated.
  bool is_truncated() const { return reader_ && reader_->is_truncated(); }

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

// Restarts the programs and plays the first `seconds` of a recorded game. Returns whether the
// programs send the recorded commands, or nullopt if a program was killed from outside.
std::optional<bool> repeats(const GameConfiguration& game, const std::filesystem::path& commands,
                            double seconds);

}  // namespace autoref::game
