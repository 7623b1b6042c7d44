#include "runner/batch/program_files.hpp"

#include <fmt/format.h>

#include <cctype>
#include <string>
#include <string_view>

#include "runner/io/checksum.hpp"
#include "runner/io/files.hpp"

namespace autoref::runner {
namespace {

namespace fs = std::filesystem;

constexpr const char* kCommandsFolder = "commands";
constexpr const char* kStderrFolder = "stderr";

constexpr int kMostKills = 5;
constexpr std::size_t kLongestName = 180;

// The id as a file's name. It may contain a factor's value, such as a command with folders.
std::string file_name(const std::string& id) {
  std::string name;
  for (const char letter : id) {
    const bool is_plain = std::isalnum(static_cast<unsigned char>(letter)) != 0 ||
                          std::string_view("._=~+-,").find(letter) != std::string_view::npos;
    name += is_plain ? std::string(1, letter)
                     : fmt::format("%{:02X}", static_cast<unsigned char>(letter));
  }
  if (name.size() <= kLongestName) return name;
  return name.substr(0, kLongestName) + crc_text(id);
}

fs::path stderr_file(const fs::path& folder, const GameConfiguration& game, char team) {
  return folder / kStderrFolder / (file_name(game.id) + "." + team + ".txt");
}

GamePrograms live_programs(const GameConfiguration& game, const fs::path& folder) {
  if (!has_programs(game)) return GamePrograms::live(game, {});
  create_folder(folder / kCommandsFolder);
  create_folder(folder / kStderrFolder);
  return GamePrograms::live(game, {commands_file(folder, game.id), stderr_file(folder, game, 'a'),
                                   stderr_file(folder, game, 'b')});
}

void finish_live(const GameConfiguration& game, const fs::path& folder, GamePrograms& programs,
                 GameRecord& record) {
  programs.finish(record);
  if (!has_programs(game)) return;
  record.is_repeatable = std::nullopt;
  if (record.status != Status::kOk) return;
  record.is_repeatable = repeats(game, commands_file(folder, game.id), kRepeated_s);
}

}  // namespace

fs::path commands_file(const fs::path& folder, const std::string& id) {
  return folder / kCommandsFolder / (file_name(id) + ".gz");
}

void play_live(const GameConfiguration& game, const fs::path& folder,
               const std::function<GameRecord&(GamePrograms&)>& play) {
  for (int attempt = 1;; ++attempt) {
    GamePrograms programs = live_programs(game, folder);
    GameRecord& record = play(programs);
    if (programs.was_killed() && attempt < kMostKills) continue;
    record.attempts = attempt;
    finish_live(game, folder, programs, record);
    return;
  }
}

GamePrograms recorded_programs(const GameConfiguration& game, const fs::path& folder) {
  const fs::path commands = commands_file(folder, game.id);
  if (!has_programs(game) || !fs::exists(commands)) return GamePrograms::live(game, {});
  return GamePrograms::recorded(game, commands);
}

GameRecord play_live(const GameConfiguration& game, const fs::path& folder) {
  GameRecord record;
  play_live(game, folder, [&game, &record](GamePrograms& programs) -> GameRecord& {
    record = play(game, nullptr, programs.maker());
    return record;
  });
  return record;
}

GameRecord play_recorded(const GameConfiguration& game, const fs::path& folder) {
  GamePrograms programs = recorded_programs(game, folder);
  GameRecord record = play(game, nullptr, programs.maker());
  programs.finish(record);
  return record;
}

}  // namespace autoref::runner
