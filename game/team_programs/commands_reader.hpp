// Reads a file of commands (commands_file.hpp).
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "game/team_programs/commands_file.hpp"
#include "game/team_programs/world_change.hpp"
#include "io/files.hpp"

namespace autoref::game {

class CommandsReader {
 public:
  // Throws InputError if `path` is not a file of commands, and InputOutputError if the file cannot
  // be read.
  explicit CommandsReader(std::filesystem::path path, io::FileKind kind = io::FileKind::kFile);
  ~CommandsReader();
  CommandsReader(const CommandsReader&) = delete;
  CommandsReader& operator=(const CommandsReader&) = delete;

  // Applies the changes made to robots before the game; call this before all other functions.
  // Throws InputError if the file is damaged or `game` does not have these robots.
  void change_robots(GameConfiguration& game);

  // The next entry, which must be an entry of `team`. Throws InputError if it is not, or if the
  // file is damaged or at its end. An entry of another team or an early end means that the file
  // belongs to another game.
  const TeamEntry& next(char team);

  // Reads the next step: returns the changes of the world before it, and keeps its entries for
  // next(). Returns nullopt if the recorded game was interrupted here, or if the file is truncated.
  // Throws InputError if the file is damaged; a file of FileKind::kFile must not be either.
  std::optional<std::vector<WorldChange>> read_step();

  // Whether the file was found to be truncated: it ends before or in this step, because the
  // recording process was killed.
  bool is_truncated() const { return is_truncated_; }

  // The final state of the game; nullopt if the file is truncated. Throws InputError if it has
  // further entries, and like read_step().
  std::optional<std::uint64_t> final_state();

 private:
  [[noreturn]] void refuse(const std::string& what) const;
  std::uint8_t peek();  // the next byte, which remains to be read
  void read(void* bytes, std::size_t size);
  void read_entry(std::size_t index);
  WorldChange read_change();
  void read_step(std::vector<WorldChange>& changes);
  template <typename Number>
  Number number();
  int robot();  // reads a robot's number; -1: none
  void read_command(RobotCommand& command);
  Vec2 vector();

  std::filesystem::path path_;
  io::FileKind kind_;
  void* file_ = nullptr;  // a gzFile
  std::array<TeamEntry, 2> last_;
  std::array<bool, 2> is_kept_{};  // whether the entry of last_ has been read but not returned
  bool is_truncated_ = false;
};

}  // namespace autoref::game
