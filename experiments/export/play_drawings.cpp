#include "experiments/export/play_drawings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <set>
#include <variant>

#include "experiments/export/sqlite_file.hpp"
#include "game/play_counts/ball_actions.hpp"
#include "io/errors.hpp"
#include "io/files.hpp"
#include "io/words.hpp"
#include "view/play_maps.hpp"

namespace autoref::experiments {
namespace {

struct DrawingKind {
  const char* file;
  const char* caption;
  std::string (*draw)(const autoref::Field& field, const std::vector<view::MappedTeam>& teams);
};
constexpr std::array<DrawingKind, 3> kKinds = {
    {{"shots.svg", "Where the teams shot from.", view::shot_map},
     {"chains.svg", "Where the teams' possession chains began and ended.", view::chain_map},
     {"losses.svg", "Where the teams lost the ball.", view::loss_map}}};

// The last line of a stored drawing.
std::string mark_of(const ResultFolder& folder) {
  return fmt::format("<!-- rows {} -->\n", rows_checksum(folder));
}

double real_in(const SqliteValue& value) {
  if (const auto* integer = std::get_if<std::int64_t>(&value)) return static_cast<double>(*integer);
  const auto* real = std::get_if<double>(&value);
  return real != nullptr ? *real : 0;
}

Vec2 point_in(const SqliteRow& row, std::size_t first) {
  return {real_in(row[first]), real_in(row[first + 1])};
}

std::string team_shown_in(const ScheduledGame& game, const std::string& letter) {
  const std::string& name = letter == "a" ? game.team_a : game.team_b;
  return game.team_a == game.team_b ? fmt::format("{}: {}", letter, name) : name;
}

bool look_alike(const autoref::Field& field, const autoref::Field& other) {
  const auto sizes = [](const autoref::Field& one) {
    const DefenceArea& area = one.defence_area;
    return std::array{one.length_m, one.width_m, one.goal_width_m, area.depth_m, area.straight_m};
  };
  return sizes(field) == sizes(other);
}

// The teams that are drawn, and their games.
class DrawnTeams {
 public:
  // `chosen` as in play_drawings().
  DrawnTeams(const ResultFolder& folder, const std::vector<std::string>& chosen)
      : folder_(folder), chosen_(chosen) {
    for (const std::size_t i : folder.good_games()) {
      const ScheduledGame& game = folder.games[i];
      bool is_drawn = false;
      for (const char* letter : {"a", "b"}) is_drawn = count(game, letter) || is_drawn;
      if (!is_drawn) continue;
      games_.push_back(i);
      game_by_id_[game.id] = &game;
    }
    check();
  }

  // The team of a row that begins with the game's id and the team's letter; null if it is not
  // drawn.
  view::MappedTeam* of(const SqliteRow& row) {
    const ScheduledGame& game = *game_by_id_.at(std::get<std::string>(row[0]));
    return find(team_shown_in(game, std::get<std::string>(row[1])));
  }

  const std::vector<view::MappedTeam>& all() const { return teams_; }
  const std::vector<std::size_t>& games() const { return games_; }

  autoref::Field field() const {
    const ScheduledGame& first = folder_.games[games_.front()];
    autoref::Field field = first.settings.combined().field;
    for (const std::size_t i : games_) {
      if (look_alike(folder_.games[i].settings.combined().field, field)) continue;
      throw io::InputError({folder_.path.string()}, "",
                           fmt::format("{} and {} are played on different fields, which one map "
                                       "cannot show; choose teams with --teams A,B",
                                       first.id, folder_.games[i].id));
    }
    return field;
  }

 private:
  view::MappedTeam* find(const std::string& name) {
    const auto team = std::find_if(teams_.begin(), teams_.end(),
                                   [&](const auto& each) { return each.name == name; });
    return team != teams_.end() ? &*team : nullptr;
  }

  // Counts a game of the team; returns whether it is drawn.
  bool count(const ScheduledGame& game, const std::string& letter) {
    const std::string& plain = letter == "a" ? game.team_a : game.team_b;
    const std::string name = team_shown_in(game, letter);
    names_.insert({plain, name});
    const auto is_name = [&](const std::string& each) { return each == plain || each == name; };
    if (!chosen_.empty() && std::none_of(chosen_.begin(), chosen_.end(), is_name)) return false;
    if (find(name) == nullptr) teams_.push_back({name, 0, {}, {}, {}});
    ++find(name)->games;
    return true;
  }

  void check() const {
    const std::vector<std::string> names(names_.begin(), names_.end());
    for (const std::string& name : chosen_) {
      if (!names_.contains(name))
        throw io::InputError(
            {"--teams"}, "",
            fmt::format("'{}' has no game that can be drawn{}", name, io::suggestion(name, names)));
    }
    if (games_.empty())
      throw io::InputError({folder_.path.string()}, "",
                           "contains no game that can be drawn; void and forfeited games cannot");
    if (teams_.size() > kMostDrawnTeams)
      throw io::InputError(
          {chosen_.empty() ? folder_.path.string() : "--teams"}, "",
          fmt::format("{} teams are too many for a map; choose at most {} with --teams A,B",
                      teams_.size(), kMostDrawnTeams));
  }

  const ResultFolder& folder_;
  std::vector<std::string> chosen_;
  std::vector<std::size_t> games_;  // positions in folder_.games
  std::map<std::string, const ScheduledGame*> game_by_id_;
  std::vector<view::MappedTeam> teams_;
  std::set<std::string> names_;  // of all teams
};

void add_play(SqliteFile& file, DrawnTeams& teams) {
  file.each_row("SELECT game_id, team, x_m, y_m, xg, is_goal FROM shots",
                [&](const SqliteRow& row) {
                  if (view::MappedTeam* team = teams.of(row))
                    team->shots.push_back({point_in(row, 2), real_in(row[4]), real_in(row[5]) > 0});
                });
  file.each_row("SELECT game_id, team, start_x_m, start_y_m, end_x_m, end_y_m, xg FROM chains",
                [&](const SqliteRow& row) {
                  if (view::MappedTeam* team = teams.of(row))
                    team->chains.push_back({point_in(row, 2), point_in(row, 4), real_in(row[6])});
                });
  file.each_row(fmt::format("SELECT game_id, team, end_x_m, end_y_m FROM actions WHERE action = "
                            "'{}'",
                            game::name_of(game::ActionKind::kLoss)),
                [&](const SqliteRow& row) {
                  if (view::MappedTeam* team = teams.of(row))
                    team->losses_m.push_back(point_in(row, 2));
                });
}

}  // namespace

std::vector<ResultDrawing> play_drawings(const ResultFolder& folder, const ReplayOptions& options,
                                         const std::vector<std::string>& chosen) {
  DrawnTeams teams(folder, chosen);
  const autoref::Field field = teams.field();
  SqliteFile file;
  add_game_tables(file, folder, teams.games(), options);
  add_play(file, teams);
  std::vector<ResultDrawing> drawings;
  drawings.reserve(kKinds.size());
  for (const DrawingKind& kind : kKinds)
    drawings.push_back({kind.file, kind.caption, kind.draw(field, teams.all())});
  return drawings;
}

void store_play_drawings(const ResultFolder& folder, const std::vector<ResultDrawing>& drawings,
                         const std::filesystem::path& into) {
  const std::string mark = mark_of(folder);
  for (const ResultDrawing& drawing : drawings)
    io::replace_file(into / drawing.name, drawing.svg + mark);
}

std::vector<ResultDrawing> stored_play_drawings(const ResultFolder& folder,
                                                const std::filesystem::path& into) {
  std::vector<ResultDrawing> drawings;
  for (const DrawingKind& kind : kKinds) {
    const std::string svg = io::read_file(into / kind.file).value_or("");
    if (!svg.empty()) drawings.push_back({kind.file, kind.caption, svg});
  }
  if (drawings.empty()) return {};
  const std::string mark = mark_of(folder);
  std::erase_if(drawings, [&](const ResultDrawing& one) { return !one.svg.ends_with(mark); });
  return drawings;
}

}  // namespace autoref::experiments
