#include "experiments/kinds/version_keys.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "experiments/reading/named_teams_reader.hpp"
#include "experiments/reading/settings_text.hpp"
#include "experiments/reading/top_reader.hpp"
#include "experiments/schedule/schedule.hpp"
#include "io/words.hpp"
#include "io/yaml_text.hpp"

namespace autoref::experiments {
namespace {

constexpr const char* kTakenOver = "taken_over";
constexpr const char* kNoRating = "none";  // of a pair number with a void game
const std::vector<std::string> kKeysOfTakenOver = {"build", "teams"};
const std::vector<std::string> kKeysOfEarlierTeam = {"build", "offset", "games", "by_pair"};

// The settings of the team's version that are given.
std::vector<game::Setting> given_settings(TeamVersions& versions, const std::string& name,
                                          const std::string& prefix) {
  const auto version = versions.of_teams.find(name);
  if (version == versions.of_teams.end()) return {};
  std::vector<game::Setting> settings = settings_of(version->second, prefix);
  std::erase_if(settings, [](const game::Setting& setting) {
    return std::get<game::FreeText>(setting.target).text->empty();
  });
  return settings;
}

Key anchors_key(TeamVersions& versions) {
  Key key{kAnchors, "list of teams; none",
          "played by every build of AutoRef, to find the offset between two builds"};
  key.read = [&versions](TopReader& top) {
    const game::YamlEntry* entry = top.find(kAnchors);
    if (entry == nullptr) return;
    versions.anchors = top.file().words(*entry, kAnchors);
    top.locations()[kAnchors] = game::value_location(*entry);
  };
  key.text = [&versions] {
    return versions.anchors.empty()
               ? ""
               : fmt::format("{}: [{}]\n", kAnchors, fmt::join(versions.anchors, ", "));
  };
  return key;
}

Key earlier_key(TeamVersions& versions) {
  Key key{
      kEarlier, "folder; none",
      "an earlier results folder, relative to this file, whose games or ratings are taken over"};
  key.read = [&versions](TopReader& top) {
    const game::YamlEntry* entry = top.find(kEarlier);
    if (entry == nullptr) return;
    const std::string text = top.file().scalar(*entry, kEarlier, "a results folder", false);
    if (text.empty())
      top.file().refuse(game::value_location(*entry), kEarlier, "expected a results folder");
    versions.earlier = std::filesystem::absolute(top.file().folder() / text).lexically_normal();
  };
  key.text = [&versions] {
    return versions.earlier.empty()
               ? ""
               : fmt::format("{}: {}\n", kEarlier, io::quoted_scalar(versions.earlier.string()));
  };
  return key;
}

double finite_number(const TopReader& top, const game::YamlEntry& entry, const std::string& text) {
  const std::optional<double> number = io::number_in(text);
  if (number && std::isfinite(*number)) return *number;
  top.file().refuse(game::value_location(entry), kTakenOver,
                    fmt::format("expected a number, found '{}'", text));
}

int game_count(const TopReader& top, const game::YamlEntry& entry, const std::string& text) {
  const std::optional<int> number = io::whole_number_in(text);
  if (number && *number >= 0) return *number;
  top.file().refuse(game::value_location(entry), kTakenOver,
                    fmt::format("expected a number of games, found '{}'", text));
}

DifferenceByPair read_by_pair(const TopReader& top, const game::YamlEntry& entry) {
  DifferenceByPair by_pair;
  int pair = 0;
  const std::vector<std::string> texts = top.file().words(entry, kTakenOver);
  if (texts.size() > kMostPairs)
    top.file().refuse(game::value_location(entry), kTakenOver,
                      fmt::format("expected at most {} pairs, found {}", kMostPairs, texts.size()));
  for (const std::string& text : texts) {
    ++pair;
    if (text != kNoRating) by_pair[pair] = finite_number(top, entry, text);
  }
  return by_pair;
}

EarlierTeam read_earlier_team(const TopReader& top, const game::YamlEntry& entry) {
  EarlierTeam team;
  const std::vector<game::YamlEntry> keys =
      top.file().entries(entry, kTakenOver, kKeysOfEarlierTeam);
  game::refuse_unknown(top.file(), keys, kKeysOfEarlierTeam);
  const auto text_of_key = [&](const char* name) {
    const game::YamlEntry& key = game::required_entry(top.file(), keys, name);
    return top.file().scalar(key, kTakenOver, "a plain value", false);
  };
  team.build = text_of_key("build");
  team.offset = finite_number(top, entry, text_of_key("offset"));
  team.games = game_count(top, entry, text_of_key("games"));
  team.by_pair = read_by_pair(top, game::required_entry(top.file(), keys, "by_pair"));
  return team;
}

TakenOver read_taken_over(const TopReader& top, const game::YamlEntry& entry) {
  TakenOver taken_over;
  const std::vector<game::YamlEntry> keys = top.file().entries(entry, kTakenOver, kKeysOfTakenOver);
  game::refuse_unknown(top.file(), keys, kKeysOfTakenOver);
  taken_over.build = top.file().scalar(game::required_entry(top.file(), keys, "build"), kTakenOver,
                                       "a build", false);
  const game::YamlEntry& teams = game::required_entry(top.file(), keys, "teams");
  for (const game::YamlEntry& team : top.file().entries(teams, kTakenOver, {}))
    taken_over.teams[team.key] = read_earlier_team(top, team);
  return taken_over;
}

std::string by_pair_text(const DifferenceByPair& by_pair) {
  std::vector<std::string> texts;
  for (const auto& [pair, rating] : by_pair) {
    texts.resize(static_cast<std::size_t>(pair) - 1, kNoRating);
    texts.push_back(fmt::format("{}", rating));
  }
  return fmt::format("{}", fmt::join(texts, ", "));
}

std::string text_of_taken_over(const TakenOver& taken_over) {
  std::string text = fmt::format(
      "{}:  # ratings in the earlier folder; written by AutoRef\n"
      "  build: {}\n  teams:{}\n",
      kTakenOver, io::quoted_scalar(taken_over.build), taken_over.teams.empty() ? " {}" : "");
  for (const auto& [name, team] : taken_over.teams)
    text += fmt::format(
        "    {}:\n      build: {}\n      offset: {}\n      games: {}\n"
        "      by_pair: [{}]\n",
        name, io::quoted_scalar(team.build), team.offset, team.games, by_pair_text(team.by_pair));
  return text;
}

Key taken_over_key(TeamVersions& versions) {
  Key key{kTakenOver, "",
          "written to `effective.yaml`: ratings in the earlier folder; do not write it yourself"};
  key.read = [&versions](TopReader& top) {
    const game::YamlEntry* entry = top.find(kTakenOver);
    if (entry != nullptr) versions.taken_over = read_taken_over(top, *entry);
  };
  key.text = [&versions] {
    return versions.taken_over ? text_of_taken_over(*versions.taken_over) : "";
  };
  return key;
}

}  // namespace

Key versioned_teams_key(const std::string& name, std::string about, Teams& teams,
                        game::GameSettings& base, TeamCount count, TeamVersions& versions) {
  Key key = teams_key(name, std::move(about), teams, base, count);
  key.about += fmt::format(
      "; `{}: 2026-09-01` is the date of a version of a team, and `{}` names its line of versions",
      kVersion, kVersionOf);
  key.read = [name, &teams, &base, count, &versions](TopReader& top) {
    const auto more = [&versions](const std::string& team, const std::string& prefix) {
      return settings_of(versions.of_teams[team], prefix);
    };
    NamedTeamsReader(top.file(), top.locations(), top.assignments(), more)
        .read(top.required(name), teams, base, count);
    std::erase_if(versions.of_teams, [](const auto& team) {
      return team.second.date.empty() && team.second.line.empty();
    });
  };
  key.text = [name, &teams, &base, &versions] {
    return teams_text(teams, name, base.types,
                      [&versions](const std::string& team, const std::string& prefix) {
                        return given_settings(versions, team, prefix);
                      });
  };
  return key;
}

std::vector<Key> earlier_keys(TeamVersions& versions) {
  return {anchors_key(versions), earlier_key(versions), taken_over_key(versions)};
}

}  // namespace autoref::experiments
