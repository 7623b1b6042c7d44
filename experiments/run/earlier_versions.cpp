#include "experiments/run/earlier_versions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <memory>
#include <stdexcept>

#include "experiments/analysis/version_tables.hpp"
#include "experiments/run/result_folder.hpp"
#include "experiments/run/reused_games.hpp"
#include "game/settings/fields.hpp"
#include "io/errors.hpp"
#include "io/files.hpp"
#include "io/words.hpp"

namespace autoref::experiments {
namespace {

namespace fs = std::filesystem;

// A team's identity: the configuration of a game against itself.
std::uint64_t identity_of(const game::TeamSettings& settings, const VersionedTeams& teams) {
  const auto team = std::make_shared<const game::TeamSettings>(settings);
  return game::configuration_hash(
      SharedSettings(*teams.base).between(team, team).with(leg_of(teams.seed, 1, 1)).combined());
}

// Compares the teams of an experiment with those of its earlier folder.
class EarlierVersions {
 public:
  EarlierVersions(Experiment& here, const VersionedTeams& teams, std::string build)
      : here_(here),
        teams_(teams),
        versions_(*teams.versions),
        build_(std::move(build)),
        folder_(versions_.earlier),
        there_(scenario_in(folder_)) {
    if (&there_.experiment().kind() != &here.kind())
      refuse(fmt::format("holds a {}, but this is a {}; give the folder of a {}", kind_of(there_),
                         here.kind().name, here.kind().name));
    teams_there_ = there_.experiment().versioned_teams().value();
    read_ratings();
  }

  TakenOver taken_over() const {
    TakenOver taken_over{build_there_, {}};
    std::size_t anchors = 0;
    for (const auto& [name, team] : *teams_.rated) {
      const auto stored = stored_.find(name);
      if (stored == stored_.end() || !is_same(name, team)) continue;
      const bool is_anchor = versions_.is_anchor(name);
      if (!is_anchor && !stored->second.is_taken_over && build_there_ == build_) continue;
      anchors += is_anchor ? 1 : 0;
      taken_over.teams[name] = stored->second.team;
    }
    if (build_there_ == build_ && taken_over.teams.size() == anchors) return taken_over;
    refuse_changed_anchors();
    refuse_changed_field();
    if (anchors == 0) refuse_without_anchor();
    refuse_lonely_team(taken_over);
    return taken_over;
  }

 private:
  [[noreturn]] void refuse(const std::string& message) const {
    throw io::InputError({folder_.string()}, kEarlier, message);
  }

  // Sets the ratings in the folder and the build that played its games.
  void read_ratings() {
    const std::optional<std::string> versions = io::read_file(folder_ / kVersionsFile);
    const std::optional<std::string> pairs = io::read_file(folder_ / kVersionPairsFile);
    if (!versions || !pairs)
      refuse(fmt::format(
          "has no {}, which a complete run writes if a team has a {} or is an anchor; finish the "
          "experiment with the build that played it, or give its teams versions and repeat it",
          !versions ? kVersionsFile : kVersionPairsFile, kVersion));
    try {
      stored_ = stored_ratings(*versions, *pairs);
    } catch (const std::invalid_argument& error) {
      refuse(fmt::format("{}; write the files again with: autoref report {}", error.what(),
                         folder_.string()));
    }
    for (const auto& [name, rating] : stored_)
      if (!rating.is_taken_over) build_there_ = rating.team.build;
  }

  // The team in the earlier folder; null if it had none of this name.
  static const game::TeamSettings* find_team(const Teams* teams, const std::string& name) {
    const auto found = teams->find(name);
    return found == teams->end() ? nullptr : &found->second;
  }

  bool is_same(const game::TeamSettings& team, const game::TeamSettings* there) const {
    return there != nullptr && has_known_content(team) &&
           identity_of(team, teams_) == identity_of(*there, teams_there_);
  }
  bool is_same(const std::string& name, const game::TeamSettings& team) const {
    return is_same(team, find_team(teams_there_.rated, name));
  }

  // Why a team of that name is not the same, as a clause of a message.
  std::string reason_for(const game::TeamSettings& team) const {
    if (!has_known_content(team))
      return "the files of its program are unknown: list them in its setting files";
    const std::string changes = changes_between(here_, there_.experiment());
    return changes.empty() ? "its settings or the files of its program have changed" : changes;
  }

  void refuse_changed_anchors() const {
    for (const std::string& anchor : versions_.anchors) {
      const game::TeamSettings& team = teams_.rated->at(anchor);
      if (!stored_.contains(anchor) || is_same(anchor, team)) continue;
      refuse(
          fmt::format("the anchor '{}' is not the same team there ({}); an anchor must not "
                      "change, so give the changed team another name",
                      anchor, reason_for(team)));
    }
  }

  void refuse_changed_field() const {
    if (teams_.field == nullptr) return;
    for (const auto& [name, team] : *teams_.field)
      if (!is_same(team, find_team(teams_there_.field, name)))
        refuse(
            fmt::format("'{}' of the field is not the same team there ({}); ratings can only be "
                        "compared against the same field",
                        name, reason_for(team)));
    for (const auto& [name, team] : *teams_there_.field)
      if (!teams_.field->contains(name))
        refuse(
            fmt::format("its field also has the team '{}'; ratings can only be compared against "
                        "the same field",
                        name));
  }

  // If both builds are the same, the folder there took over ratings of a team that both have.
  [[noreturn]] void refuse_without_anchor() const {
    std::vector<std::string> common;
    for (const auto& [name, team] : *teams_.rated)
      if (stored_.contains(name) && is_same(name, team)) common.push_back(name);
    if (build_there_ == build_)
      refuse(
          fmt::format("took over ratings of an earlier build of AutoRef, and no anchor is in both "
                      "folders, so they cannot be compared with the ratings here; list an anchor "
                      "that is in both, such as {}: [{}] (any of {})",
                      kAnchors, common.front(), io::listed(common)));
    const std::string played =
        fmt::format("holds ratings of build {}, but this is build {}", build_there_, build_);
    if (common.empty())
      refuse(played + ", and no team is the same in both; " +
             reason_for(teams_.rated->begin()->second));
    refuse(
        fmt::format("{}, and no anchor is in both, so their ratings cannot be compared; list "
                    "teams to play again, such as {}: [{}] (any of {})",
                    played, kAnchors, common.front(), io::listed(common)));
  }

  void refuse_lonely_team(const TakenOver& taken_over) const {
    TeamVersions resolved = versions_;
    resolved.taken_over = taken_over;
    if (teams_.field == nullptr && played_teams(*teams_.rated, resolved).size() < 2)
      refuse(fmt::format("only one team would play; list another one in {}", kAnchors));
  }

  Experiment& here_;
  const VersionedTeams teams_;
  const TeamVersions& versions_;
  const std::string build_;
  const fs::path folder_;
  Scenario there_;
  VersionedTeams teams_there_;
  std::map<std::string, StoredRating> stored_;
  std::string build_there_;
};

}  // namespace

void take_over_versions(Scenario& scenario, const std::string& build) {
  Experiment& experiment = scenario.experiment();
  const std::optional<VersionedTeams> teams = experiment.versioned_teams();
  if (!teams || teams->versions->earlier.empty() || teams->versions->taken_over) return;
  teams->versions->taken_over = EarlierVersions(experiment, *teams, build).taken_over();
}

std::string note_on_taken_over(const Experiment& experiment) {
  const std::unique_ptr<Experiment> copy = experiment.copy();
  const std::optional<VersionedTeams> teams = copy->versioned_teams();
  if (!teams) return {};
  const std::size_t all = teams->rated->size();
  const std::size_t played = played_teams(*teams->rated, *teams->versions).size();
  if (played == all) return {};
  return fmt::format("{} of {} teams are not played again; their ratings are taken over from {}",
                     all - played, all, teams->versions->earlier.string());
}

fs::path reusable_earlier_folder(const Experiment& experiment, const std::string& build) {
  const std::optional<TeamVersions> versions = versions_of(experiment);
  const bool is_of_build = versions && versions->taken_over && versions->taken_over->build == build;
  return is_of_build ? versions->earlier : fs::path();
}

void refuse_earlier_folder(const Experiment& experiment, const fs::path& folder) {
  const std::optional<TeamVersions> versions = versions_of(experiment);
  std::error_code none;
  if (!versions || versions->earlier.empty() || !fs::equivalent(versions->earlier, folder, none))
    return;
  throw io::InputError({folder.string()}, kEarlier,
                       "the results would go into the earlier folder itself; choose another folder "
                       "with -o");
}

}  // namespace autoref::experiments
