#include "experiments/schedule/team_versions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "game/settings/setting_value.hpp"
#include "io/words.hpp"

namespace autoref::experiments {
namespace {

constexpr std::size_t kDateLength = 10;  // "2026-09-01"

std::optional<std::chrono::year_month_day> date_in(std::string_view text) {
  if (text.size() != kDateLength || text[4] != '-' || text[7] != '-') return std::nullopt;
  const auto is_digit = [](char c) { return c == '-' || (c >= '0' && c <= '9'); };
  if (!std::all_of(text.begin(), text.end(), is_digit)) return std::nullopt;
  const auto number = [text](std::size_t from, std::size_t digits) {
    return io::whole_number_in(text.substr(from, digits)).value_or(-1);
  };
  const std::chrono::year_month_day date{std::chrono::year(number(0, 4)),
                                         std::chrono::month(static_cast<unsigned>(number(5, 2))),
                                         std::chrono::day(static_cast<unsigned>(number(8, 2)))};
  return date.ok() && number(0, 4) >= 0 ? std::optional(date) : std::nullopt;
}

std::vector<std::string> names_of_teams(const Teams& teams) {
  std::vector<std::string> names;
  for (const auto& [name, team] : teams) names.push_back(name);
  return names;
}

}  // namespace

bool TeamVersions::is_anchor(const std::string& team) const {
  return std::find(anchors.begin(), anchors.end(), team) != anchors.end();
}

bool TeamVersions::is_taken_over(const std::string& team) const {
  return taken_over && taken_over->teams.contains(team) && !is_anchor(team);
}

std::vector<game::Setting> settings_of(TeamVersion& version, const std::string& prefix) {
  return {{prefix + kVersion,
           game::FreeText{&version.date},
           {},
           {},
           "",
           "date of this version of a team, such as 2026-09-01"},
          {prefix + kVersionOf,
           game::FreeText{&version.line},
           {},
           {},
           "",
           "name of its line of versions, if there are several"}};
}

bool is_date(std::string_view text) { return date_in(text).has_value(); }

int days_between(const std::string& from, const std::string& to) {
  return static_cast<int>(
      (std::chrono::sys_days(date_in(to).value()) - std::chrono::sys_days(date_in(from).value()))
          .count());
}

std::string date_after(const std::string& date, int days) {
  const std::chrono::year_month_day later{std::chrono::sys_days(date_in(date).value()) +
                                          std::chrono::days(days)};
  return fmt::format("{:04}-{:02}-{:02}", static_cast<int>(later.year()),
                     static_cast<unsigned>(later.month()), static_cast<unsigned>(later.day()));
}

Teams played_teams(const Teams& teams, const TeamVersions& versions) {
  Teams played = teams;
  std::erase_if(played, [&](const auto& team) { return versions.is_taken_over(team.first); });
  return played;
}

void check(const TeamVersions& versions, const Teams& teams, std::string_view branch) {
  for (const auto& [name, version] : versions.of_teams) {
    const std::string path = fmt::format("{}.{}.", branch, name);
    if (version.date.empty() && !version.line.empty())
      throw game::SettingError(
          path + kVersionOf,
          fmt::format(": the team's date is missing; add {}: 2026-09-01, for example", kVersion));
    if (!version.date.empty() && !is_date(version.date))
      throw game::SettingError(
          path + kVersion,
          fmt::format(": expected a date such as 2026-09-01, found '{}'", version.date));
  }
  for (auto anchor = versions.anchors.begin(); anchor != versions.anchors.end(); ++anchor) {
    if (!teams.contains(*anchor))
      throw game::SettingError(
          kAnchors, fmt::format(": '{}' is not one of the {}, which are {}", *anchor, branch,
                                io::listed(names_of_teams(teams))));
    if (std::find(versions.anchors.begin(), anchor, *anchor) != anchor)
      throw game::SettingError(kAnchors, fmt::format(": '{}' is listed twice", *anchor));
  }
}

}  // namespace autoref::experiments
