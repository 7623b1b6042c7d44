#include "experiments/run/program_files.hpp"

#include <fmt/format.h>

#include <cctype>
#include <string>
#include <string_view>

#include "io/checksum.hpp"
#include "io/files.hpp"

namespace autoref::experiments {
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
  return name.substr(0, kLongestName) + io::crc_text(id);
}

fs::path stderr_file(const fs::path& folder, const game::GameConfiguration& game, char team) {
  return folder / kStderrFolder / (file_name(game.id) + "." + team + ".txt");
}

game::GamePrograms live_programs(const game::GameConfiguration& game, const fs::path& folder) {
  if (!game::has_programs(game)) return game::GamePrograms::live(game, {});
  io::create_folder(folder / kCommandsFolder);
  io::create_folder(folder / kStderrFolder);
  return game::GamePrograms::live(game,
                                  {commands_file(folder, game.id), stderr_file(folder, game, 'a'),
                                   stderr_file(folder, game, 'b')});
}

void finish_live(const game::GameConfiguration& game, const fs::path& folder,
                 game::GamePrograms& programs, game::GameRecord& record) {
  programs.finish(record);
  if (!game::has_programs(game)) return;
  record.is_repeatable = std::nullopt;
  if (record.status != game::Status::kOk) return;
  record.is_repeatable = game::repeats(game, commands_file(folder, game.id), kRepeated_s);
}

}  // namespace

fs::path commands_file(const fs::path& folder, const std::string& id) {
  return folder / kCommandsFolder / (file_name(id) + ".gz");
}

void play_live(const game::GameConfiguration& game, const fs::path& folder,
               const std::function<game::GameRecord&(game::GamePrograms&)>& play) {
  for (int attempt = 1;; ++attempt) {
    game::GamePrograms programs = live_programs(game, folder);
    game::GameRecord& record = play(programs);
    if (programs.was_killed() && attempt < kMostKills) continue;
    record.attempts = attempt;
    finish_live(game, folder, programs, record);
    return;
  }
}

game::GamePrograms recorded_programs(const game::GameConfiguration& game, const fs::path& folder) {
  const fs::path commands = commands_file(folder, game.id);
  if (!game::has_programs(game) || !fs::exists(commands)) return game::GamePrograms::live(game, {});
  return game::GamePrograms::recorded(game, commands);
}

game::GameRecord play_live(const game::GameConfiguration& game, const fs::path& folder) {
  game::GameRecord record;
  play_live(game, folder, [&game, &record](game::GamePrograms& programs) -> game::GameRecord& {
    record = game::play(game, nullptr, programs.maker());
    return record;
  });
  return record;
}

game::GameRecord play_recorded(const game::GameConfiguration& game, const fs::path& folder) {
  game::GamePrograms programs = recorded_programs(game, folder);
  game::GameRecord record = game::play(game, nullptr, programs.maker());
  programs.finish(record);
  return record;
}

}  // namespace autoref::experiments
