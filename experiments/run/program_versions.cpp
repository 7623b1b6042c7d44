#include "experiments/run/program_versions.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cctype>
#include <optional>
#include <string>
#include <string_view>

#include "game/settings/command_text.hpp"
#include "game/settings/fields.hpp"
#include "io/checksum.hpp"
#include "io/errors.hpp"
#include "io/files.hpp"

namespace autoref::experiments {
namespace {

namespace fs = std::filesystem;

constexpr const char* kCommandsFolder = "commands";
constexpr const char* kStderrFolder = "stderr";

constexpr int kMostKills = 5;
constexpr std::size_t kLongestFileName = 180;

// The game id as a file name. It may contain a factor's value, such as a command with a path.
std::string file_name(const std::string& id) {
  std::string name;
  for (const char letter : id) {
    const bool is_plain = std::isalnum(static_cast<unsigned char>(letter)) != 0 ||
                          std::string_view("._=~+-,").find(letter) != std::string_view::npos;
    name += is_plain ? std::string(1, letter)
                     : fmt::format("%{:02X}", static_cast<unsigned char>(letter));
  }
  if (name.size() <= kLongestFileName) return name;
  return name.substr(0, kLongestFileName) + io::crc_text(id);
}

fs::path stderr_file(const fs::path& folder, const std::string& id, char team) {
  return folder / kStderrFolder / (file_name(id) + "." + team + ".txt");
}

void copy_if_there(const fs::path& from, const fs::path& to) {
  const std::optional<std::string> content = io::read_file(from);
  if (!content) return;
  io::create_folder(to.parent_path());
  io::replace_file(to, *content);
}

game::GamePrograms live_programs(const game::GameConfiguration& game, const fs::path& folder) {
  if (!game::has_programs(game)) return game::GamePrograms::live(game, {});
  io::create_folder(folder / kCommandsFolder);
  io::create_folder(folder / kStderrFolder);
  return game::GamePrograms::live(
      game, {commands_file(folder, game.id), stderr_file(folder, game.id, 'a'),
             stderr_file(folder, game.id, 'b')});
}

void finish_live(const game::GameConfiguration& game, const fs::path& folder,
                 game::GamePrograms& programs, game::GameRecord& record) {
  programs.finish(record);
  if (!game::has_programs(game)) return;
  record.is_repeatable = std::nullopt;
  if (record.status != game::Status::kOk) return;
  record.is_repeatable = game::repeats(game, commands_file(folder, game.id), kRepeated_s);
}

constexpr std::size_t kMostFiles = 10'000;
constexpr std::uintmax_t kMostBytes = std::uintmax_t{1} << 30;

struct ProgramFile {
  std::string name;  // path as given, or relative to the given folder
  fs::path path;
};
using ProgramFileList = std::vector<ProgramFile>;

struct VersionedTeam {
  game::TeamSettings* team = nullptr;
  std::string path;                          // path of its settings
  std::vector<game::TeamSettings> variants;  // the team, or one for each value of a factor
};
using VersionedTeams = std::vector<VersionedTeam>;

// Changes a setting that determines the files; returns false for other settings.
bool set(const std::string& name, const std::string& text, game::TeamSettings& team) {
  if (name == "directory") {
    team.program.directory = text;
  } else if (name == "command") {
    team.program.command = game::words_of_command(text);
  } else if (name == "files") {
    team.files = game::words_of_command(text);
  } else {
    return false;
  }
  return true;
}

void vary(const Factor& factor, VersionedTeam& team) {
  const std::string path = game::full_path(factor.path);
  if (!path.starts_with(team.path + ".")) return;
  const std::string name = path.substr(team.path.size() + 1);
  std::vector<game::TeamSettings> variants;
  for (const game::TeamSettings& one : team.variants) {
    for (const game::SettingValue& value : factor.values) {
      game::TeamSettings varied = one;
      const auto* text = std::get_if<std::string>(&value);
      if (text == nullptr || !set(name, *text, varied)) return;
      variants.push_back(std::move(varied));
    }
  }
  team.variants = std::move(variants);
}

// The teams of the experiment, which must outlive the result.
VersionedTeams teams_of(Experiment& experiment) {
  VersionedTeams all;
  for (const Key& key : experiment.keys()) {
    if (!key.teams) continue;
    for (const TeamAt& at : key.teams()) all.push_back({at.team, at.path, {*at.team}});
  }
  for (const Factor& factor : experiment.varied_settings()) {
    for (VersionedTeam& team : all) vary(factor, team);
  }
  return all;
}

VersionedTeams teams_of(Scenario& scenario) {
  if (auto* game = std::get_if<game::GameSettings>(&scenario.content))
    return {{&game->a, "teams.a", {game->a}}, {&game->b, "teams.b", {game->b}}};
  return teams_of(scenario.experiment());
}

[[noreturn]] void refuse(const std::string& team_path, const std::string& why) {
  throw io::InputError({}, team_path + ".files", why);
}

bool is_left_out(const fs::path& path) {
  const std::string name = path.filename().string();
  return name.starts_with('.') || name == "__pycache__";
}

void add_folder(const std::string& name, const fs::path& folder, ProgramFileList& files) {
  for (fs::recursive_directory_iterator entry(folder), end; entry != end; ++entry) {
    if (is_left_out(entry->path())) {
      entry.disable_recursion_pending();
    } else if (entry->is_regular_file()) {
      files.push_back(
          {name + "/" + entry->path().lexically_relative(folder).string(), entry->path()});
      if (files.size() > kMostFiles) return;
    }
  }
}

void add_files(const game::TeamSettings& team, ProgramFileList& files) {
  for (const std::string& name : team.files) {
    const fs::path path = fs::path(team.program.directory) / name;
    if (fs::is_directory(path)) {
      add_folder(name, path, files);
    } else if (fs::is_regular_file(path)) {
      files.push_back({name, path});
    } else {
      throw fs::filesystem_error("not a file or folder", path, {});
    }
  }
  if (!team.files.empty()) return;
  for (const std::string& word : team.program.command) {
    const fs::path path = fs::path(team.program.directory) / word;
    std::error_code error;
    if (fs::is_regular_file(path, error)) files.push_back({word, path});
  }
}

ProgramFileList files_of(const std::string& path, const std::vector<game::TeamSettings>& variants) {
  ProgramFileList files;
  for (const game::TeamSettings& team : variants) {
    ProgramFileList its;
    try {
      if (!team.program.command.empty()) add_files(team, its);
    } catch (const fs::filesystem_error& error) {
      refuse(path, fmt::format("cannot read the file or folder {}", error.path1().string()));
    }
    std::sort(its.begin(), its.end(),
              [](const ProgramFile& a, const ProgramFile& b) { return a.name < b.name; });
    files.insert(files.end(), its.begin(), its.end());
  }
  if (files.size() > kMostFiles) refuse(path, fmt::format("more than {} files", kMostFiles));
  return files;
}

bool is_read(const fs::path& file, const io::TakePiece& take) {
  try {
    return io::read_pieces(file, take);
  } catch (const io::InputOutputError&) {
    return false;
  }
}

// Returns an empty string if there are no files.
std::string hash_of(const std::string& path, const std::vector<game::TeamSettings>& variants) {
  const ProgramFileList files = files_of(path, variants);
  if (files.empty()) return {};
  io::ByteHash hash;
  std::uintmax_t bytes = 0;
  for (const ProgramFile& file : files) {
    std::error_code error;
    hash.add(fmt::format("{}\n{}\n", file.name, fs::file_size(file.path, error)));
    const auto add = [&](std::string_view piece) {
      hash.add(piece);
      bytes += piece.size();
      if (bytes > kMostBytes) refuse(path, "more than 1 GiB; list only the files that matter");
    };
    if (!is_read(file.path, add))
      refuse(path, fmt::format("{} cannot be read", file.path.string()));
  }
  return io::hash_text(hash.value());
}

}  // namespace

fs::path commands_file(const fs::path& folder, const std::string& id) {
  return folder / kCommandsFolder / (file_name(id) + ".gz");
}

void copy_program_files(const fs::path& from, const fs::path& to, const std::string& id) {
  copy_if_there(commands_file(from, id), commands_file(to, id));
  for (const char team : {'a', 'b'})
    copy_if_there(stderr_file(from, id, team), stderr_file(to, id, team));
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

void note_program_versions(Scenario& scenario) {
  for (const VersionedTeam& team : teams_of(scenario))
    team.team->files_hash = hash_of(team.path, team.variants);
}

ProgramChanges::ProgramChanges(const Scenario& scenario) {
  Scenario copy = scenario;
  for (const VersionedTeam& team : teams_of(copy)) {
    if (team.team->files_hash.empty()) continue;
    WatchedProgram program{team.path, team.variants, {}};
    program.files = look_at(program);
    programs_.push_back(std::move(program));
  }
}

std::vector<ProgramChanges::Watched> ProgramChanges::look_at(const WatchedProgram& program) {
  std::vector<Watched> seen;
  for (const ProgramFile& file : files_of(program.path, program.variants)) {
    std::error_code error;
    seen.push_back(
        {file.path, fs::last_write_time(file.path, error), fs::file_size(file.path, error)});
  }
  return seen;
}

std::vector<std::string> ProgramChanges::changed_settings() {
  std::vector<std::string> settings;
  for (WatchedProgram& program : programs_) {
    bool is_same = false;
    try {
      const std::vector<Watched> seen = look_at(program);
      is_same = seen == program.files ||
                hash_of(program.path, program.variants) == program.variants.front().files_hash;
      program.files = seen;
    } catch (const io::InputError&) {
      // A file is missing.
    }
    if (!is_same) settings.push_back(program.path + ".files");
  }
  return settings;
}

}  // namespace autoref::experiments
