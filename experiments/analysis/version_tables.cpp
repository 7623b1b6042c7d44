#include "experiments/analysis/version_tables.hpp"

#include <fmt/format.h>

#include <climits>
#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "io/csv.hpp"
#include "io/table_columns.hpp"
#include "io/words.hpp"

namespace autoref::experiments {
namespace {

constexpr const char* kTeamColumn = "team";
constexpr const char* kPairColumn = "pair";
constexpr const char* kRatingColumn = "rating";
constexpr const char* kGamesColumn = "games";
constexpr const char* kBuildColumn = "build";
constexpr const char* kOffsetColumn = "offset";

std::optional<double> change_of(const VersionRating& team) {
  return team.change ? team.change->mean : std::nullopt;
}

io::TableColumns<VersionRating> version_columns() {
  using Columns = io::TableColumns<VersionRating>;
  return io::joined(
      Columns{{kTeamColumn, &VersionRating::team, io::kInJson},
              {"line", [](const VersionRating& one) { return one.version.line; }, io::kInJson},
              {"date", [](const VersionRating& one) { return one.version.date; }, io::kInJson},
              {kRatingColumn, &VersionRating::rating, io::kInJson}},
      interval_columns<VersionRating>("", &VersionRating::interval, io::kInJson),
      Columns{{"change", change_of, io::kInJson}},
      interval_columns<VersionRating>(
          "change_",
          [](const VersionRating& one) { return one.change ? one.change->interval : std::nullopt; },
          io::kInJson),
      Columns{
          {"pairs", [](const VersionRating& one) { return static_cast<int>(one.by_pair.size()); },
           io::kInJson},
          {kGamesColumn, &VersionRating::games, io::kInJson},
          {kBuildColumn, &VersionRating::build, io::kInJson},
          {kOffsetColumn, &VersionRating::offset, io::kInJson},
          {"anchor",
           [](const VersionRating& one) -> std::string { return one.is_anchor ? "yes" : "no"; },
           io::kInJson}});
}

std::string rating_text(const VersionRating& team) {
  const std::optional<double> rating = team.rating();
  return rating ? mean_text(*rating, team.interval(), team.by_pair.size()) : "-";
}

std::string version_change_text(const VersionRating& team) {
  if (!team.change) return "";
  return team.change->mean
             ? mean_text(*team.change->mean, team.change->interval, team.change->pairs)
             : "-";
}

std::string player_text(const VersionRating& team) {
  if (team.offset) return fmt::format("{}, offset {:+.2f}", team.build, *team.offset);
  return team.build + (team.is_anchor ? ", anchor" : "");
}

bool has_lines(const std::vector<VersionRating>& teams) {
  for (const VersionRating& team : teams)
    if (!team.version.line.empty()) return true;
  return false;
}

std::string deviating_text(const BuildOffset& offset) {
  std::vector<std::string> texts;
  for (const BuildOffset::Deviation& one : offset.deviations)
    texts.push_back(fmt::format("{} {:+.2f}, p {}", one.anchor, *one.from_others.mean,
                                p_text(*one.from_others.p_holm)));
  return fmt::format(
      "\nThe anchors changed differently (from the mean change of the others: {}): a single offset "
      "does not describe what the update changes, so the ratings of teams that were not played "
      "again may be off.\n",
      fmt::join(texts, "; "));
}

std::string offset_text(const BuildOffset& offset) {
  const std::vector<double> sample = values_of(offset.by_pair);
  const std::string change =
      offset.from == offset.to
          ? "The teams played here differ from those of the earlier folder"
          : fmt::format("Build {} of AutoRef played here, {} in the earlier folder",
                        offset.to.empty() ? "?" : offset.to, offset.from);
  if (sample.empty())
    return fmt::format(
        "\n{}: the offset between the ratings is not known before all anchors have "
        "completed a pair number that they also completed there.\n",
        change);
  std::string text = fmt::format(
      "\n{}: the offset between the ratings, in goals per game, is {}, the mean change of {} "
      "anchor{} "
      "over {} pair number{}. It is added to the ratings of teams that were not played again.\n",
      change, mean_text(*mean_of(sample), mean_interval(sample), sample.size()), offset.anchors,
      offset.anchors == 1 ? "" : "s", sample.size(), sample.size() == 1 ? "" : "s");
  if (!offset.deviations.empty()) text += deviating_text(offset);
  return text;
}

// The rows of a file as cells by column. Throws std::invalid_argument.
std::vector<std::map<std::string, std::string>> rows_of_file(const std::string& name,
                                                             const std::string& text) {
  std::vector<std::map<std::string, std::string>> rows;
  io::Cells heads;
  for (const std::string_view line : io::lines_as_written(text)) {
    const std::optional<io::Cells> cells = io::csv_cells(line);
    if (!cells || (!heads.empty() && cells->size() != heads.size()))
      throw std::invalid_argument(fmt::format("{}, line {}, is damaged", name, rows.size() + 2));
    if (heads.empty()) {
      heads = *cells;
      continue;
    }
    rows.emplace_back();
    for (std::size_t i = 0; i < heads.size(); ++i) rows.back()[heads[i]] = (*cells)[i];
  }
  return rows;
}

const std::string& cell_of_column(const std::map<std::string, std::string>& row,
                                  const char* column) {
  const auto found = row.find(column);
  if (found != row.end()) return found->second;
  throw std::invalid_argument(fmt::format("the column {} is missing", column));
}

double number_in_column(const std::map<std::string, std::string>& row, const char* column) {
  const std::optional<double> number = io::number_in(cell_of_column(row, column));
  if (number && std::isfinite(*number)) return *number;
  throw std::invalid_argument(fmt::format("expected a number in column {}, found '{}'", column,
                                          cell_of_column(row, column)));
}

int whole_number_in_column(const std::map<std::string, std::string>& row, const char* column,
                           int low, int high) {
  const std::optional<int> number = io::whole_number_in(cell_of_column(row, column));
  if (number && *number >= low && *number <= high) return *number;
  throw std::invalid_argument(
      fmt::format("expected a whole number from {} to {} in column {}, found '{}'", low, high,
                  column, cell_of_column(row, column)));
}

}  // namespace

std::string versions_csv(const std::vector<VersionRating>& teams) {
  return io::csv_text(io::table_rows(version_columns(), teams));
}

std::string version_pairs_csv(const std::vector<VersionRating>& teams) {
  std::vector<io::Cells> rows = {{kTeamColumn, kPairColumn, kRatingColumn}};
  for (const VersionRating& team : teams)
    for (const auto& [pair, rating] : team.by_pair)
      rows.push_back({team.team, std::to_string(pair), fmt::format("{}", rating)});
  return io::csv_text(rows);
}

std::map<std::string, StoredRating> stored_ratings(const std::string& versions,
                                                   const std::string& version_pairs) {
  std::map<std::string, StoredRating> ratings;
  for (const auto& row : rows_of_file(kVersionsFile, versions)) {
    StoredRating& rating = ratings[cell_of_column(row, kTeamColumn)];
    rating.is_taken_over = !cell_of_column(row, kOffsetColumn).empty();
    rating.team.build = cell_of_column(row, kBuildColumn);
    rating.team.games = whole_number_in_column(row, kGamesColumn, 0, INT_MAX);
    if (rating.is_taken_over) rating.team.offset = number_in_column(row, kOffsetColumn);
  }
  for (const auto& row : rows_of_file(kVersionPairsFile, version_pairs)) {
    const auto rating = ratings.find(cell_of_column(row, kTeamColumn));
    const int pair = whole_number_in_column(row, kPairColumn, 1, kMostPairs);
    if (rating == ratings.end())
      throw std::invalid_argument(
          fmt::format("{} does not belong to {}", kVersionPairsFile, kVersionsFile));
    rating->second.team.by_pair[pair] = number_in_column(row, kRatingColumn);
  }
  return ratings;
}

io::TextBlocks versions_table(const VersionRatings& ratings) {
  const bool with_lines = has_lines(ratings.teams);
  io::Cells heads = {"date", "version", "rating over time [95 %]", "change [95 %]"};
  if (with_lines) heads.insert(heads.begin(), "line");
  if (ratings.offset) heads.emplace_back("played by");
  std::vector<io::Cells> rows = {heads};
  for (const VersionRating& team : ratings.teams) {
    io::Cells cells = {team.version.date, team.team, rating_text(team), version_change_text(team)};
    if (with_lines) cells.insert(cells.begin(), team.version.line);
    if (ratings.offset) cells.push_back(player_text(team));
    rows.push_back(std::move(cells));
  }
  std::vector<io::Align> columns(with_lines ? 3 : 2, io::Align::kLeft);
  const std::size_t keys = columns.size();
  if (ratings.offset) {
    columns.insert(columns.end(), 2, io::Align::kRight);
    columns.push_back(io::Align::kLeft);
  }
  std::string note =
      "\nRatings over time are in goals per game; a change is that from the version before, over "
      "pairs with the same seeds. The unit of these intervals is the pair number.\n";
  io::TextBlocks blocks = {"\n", io::TextTable{std::move(rows), std::move(columns), keys}, note};
  if (ratings.offset) blocks.emplace_back(offset_text(*ratings.offset));
  return blocks;
}

io::Json json_of(const std::vector<VersionRating>& teams) {
  const io::TableColumns<VersionRating> columns = version_columns();
  io::Json all = io::Json::array();
  for (const VersionRating& team : teams) {
    all.push_back(io::Json::object());
    io::add_members(all.back(), columns, team);
  }
  return all;
}

io::Json json_of(const BuildOffset& offset) {
  const std::vector<double> sample = values_of(offset.by_pair);
  io::Json object{{"from", offset.from},
                  {"to", offset.to},
                  {"anchors", offset.anchors},
                  {"pairs", sample.size()}};
  io::add_member(object, "mean", mean_of(sample));
  io::add_member(object, "low95", bounds_of(mean_interval(sample)).first);
  io::add_member(object, "high95", bounds_of(mean_interval(sample)).second);
  object["deviating"] = io::Json::array();
  for (const BuildOffset::Deviation& one : offset.deviations)
    object["deviating"].push_back(one.anchor);
  return object;
}

}  // namespace autoref::experiments
