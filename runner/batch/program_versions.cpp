#include "runner/batch/program_versions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <functional>

#include "runner/experiments/with_kind.hpp"
#include "runner/io/checksum.hpp"
#include "runner/io/errors.hpp"
#include "runner/settings/command_text.hpp"

namespace autoref::runner {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostFiles = 10'000;
constexpr std::uintmax_t kMostBytes = std::uintmax_t{1} << 30;

struct ProgramFile {
  std::string name;  // as it is named, or below the folder that is named
  fs::path path;
};
using ProgramFileList = std::vector<ProgramFile>;

// A team of a scenario, or several that share their settings.
struct VersionedTeam {
  TeamSettings* team = nullptr;
  std::string path;                                // of its settings
  std::vector<std::vector<std::string>> commands;  // with the values that a factor gives it
};
using VersionedTeams = std::vector<VersionedTeam>;

void add(TeamSettings& team, std::string path, VersionedTeams& all) {
  all.push_back({&team, std::move(path), {team.command}});
}

void add(Teams& teams, std::string_view branch, VersionedTeams& all) {
  for (auto& [name, team] : teams) add(team, fmt::format("{}.{}", branch, name), all);
}

void list(GameSettings& game, VersionedTeams& all) {
  add(game.a, "teams.a", all);
  add(game.b, "teams.b", all);
}

// The values of a factor share the files of all of them.
void list(Sweep& sweep, VersionedTeams& all) {
  list(sweep.base, all);
  for (const Factor& factor : sweep.factors) {
    for (VersionedTeam& team : all) {
      if ("teams." + factor.path != team.path + ".command") continue;
      for (const SettingValue& value : factor.values)
        team.commands.push_back(words_of_command(std::get<std::string>(value)));
    }
  }
}

void list(JudgeSchedule& schedule, VersionedTeams& all) { list(schedule.base, all); }
void list(NamedTeams& named, VersionedTeams& all) { add(named.teams, "teams", all); }
void list(Gauntlet& gauntlet, VersionedTeams& all) {
  add(gauntlet.teams, "teams", all);
  add(gauntlet.challengers, "challengers", all);
}
void list(Situations& situations, VersionedTeams& all) {
  add(situations.attackers, "attackers", all);
  add(situations.defenders, "defenders", all);
}
void list(Tuning& tuning, VersionedTeams& all) {
  add(tuning.team, "team", all);
  add(tuning.opponents, "opponents", all);
}

VersionedTeams teams_of(Scenario& scenario) {
  VersionedTeams all;
  std::visit([&all](auto& content) { list(content, all); }, scenario.content);
  return all;
}

[[noreturn]] void refuse(const VersionedTeam& team, const std::string& why) {
  throw InputError({}, team.path + ".files", why);
}

void add_folder(const std::string& name, const fs::path& folder, ProgramFileList& files) {
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
    if (!entry.is_regular_file()) continue;
    files.push_back({name + "/" + entry.path().lexically_relative(folder).string(), entry.path()});
    if (files.size() > kMostFiles) return;
  }
}

void add_named(const VersionedTeam& team, const std::string& name, ProgramFileList& files) {
  const fs::path path = fs::path(team.team->directory) / name;
  if (fs::is_directory(path)) return add_folder(name, path, files);
  if (!fs::is_regular_file(path)) refuse(team, fmt::format("there is no file {}", path.string()));
  files.push_back({name, path});
}

ProgramFileList files_of(const VersionedTeam& team) {
  ProgramFileList files;
  try {
    for (const std::string& name : team.team->files) add_named(team, name, files);
    if (team.team->files.empty()) {
      for (const auto& command : team.commands) {
        for (const std::string& word : command) {
          const fs::path path = fs::path(team.team->directory) / word;
          std::error_code error;
          if (fs::is_regular_file(path, error)) files.push_back({word, path});
        }
      }
    }
  } catch (const fs::filesystem_error& error) {
    refuse(team, error.what());
  }
  if (files.size() > kMostFiles) refuse(team, fmt::format("more than {} files", kMostFiles));
  std::sort(files.begin(), files.end(),
            [](const ProgramFile& a, const ProgramFile& b) { return a.name < b.name; });
  return files;
}

// Empty without files.
std::string hash_of(const VersionedTeam& team) {
  const ProgramFileList files = files_of(team);
  if (files.empty()) return {};
  ByteHash hash;
  std::uintmax_t bytes = 0;
  std::string chunk(std::size_t{1} << 16, '\0');
  for (const ProgramFile& file : files) {
    hash.add(fmt::format("{}\n{}\n", file.name, fs::file_size(file.path)));
    std::ifstream stream(file.path, std::ios::binary);
    while (stream) {
      stream.read(chunk.data(), static_cast<std::streamsize>(chunk.size()));
      const auto size = static_cast<std::size_t>(stream.gcount());
      hash.add(std::string_view(chunk).substr(0, size));
      bytes += size;
      if (bytes > kMostBytes)
        refuse(team, "its files have more than 1 GiB; name those that matter");
    }
    if (!stream.eof()) refuse(team, fmt::format("{} cannot be read", file.path.string()));
  }
  return hash_text(hash.value());
}

}  // namespace

void note_program_versions(Scenario& scenario) {
  for (const VersionedTeam& team : teams_of(scenario)) team.team->files_hash = hash_of(team);
}

ProgramWatch::ProgramWatch(const Scenario& scenario) {
  Scenario copy = scenario;
  for (const VersionedTeam& team : teams_of(copy)) {
    if (team.team->files_hash.empty()) continue;
    for (const ProgramFile& file : files_of(team)) files_.push_back(look_at(file.path));
  }
}

ProgramWatch::Watched ProgramWatch::look_at(const fs::path& file) {
  std::error_code error;
  return {file, fs::last_write_time(file, error), fs::file_size(file, error)};
}

std::vector<std::string> ProgramWatch::changed() const {
  std::vector<std::string> names;
  for (const Watched& watched : files_) {
    if (!(look_at(watched.file) == watched)) names.push_back(watched.file.string());
  }
  return names;
}

}  // namespace autoref::runner
