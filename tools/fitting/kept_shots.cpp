#include "tools/fitting/kept_shots.hpp"

#include <fmt/format.h>

#include <memory>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string_view>
#include <type_traits>
#include <utility>

#include "game/loop/observer.hpp"
#include "io/csv.hpp"
#include "io/files.hpp"

namespace autoref::tools {
namespace {

constexpr std::size_t kMostBatches = 1000;
constexpr std::string_view kEndOfGame = "\n";  // the text of a game must not be empty

// Calls `action` with the name and the value of each column, in the order of the file.
void for_each_column(auto& shot, auto&& action) {
  action("team", shot.team);
  action("opponent", shot.opponent);
  action("has_scored", shot.has_scored);
  auto& situation = shot.situation;
  action("distance_m", situation.distance_m);
  action("opening_rad", situation.opening_rad);
  action("time_s", situation.time_s);
  action("keeper_m", situation.keeper_m);
  action("keeper_out_m", situation.keeper_out_m);
  action("keeper_mps", situation.keeper_mps);
  action("opponent_m", situation.opponent_m);
  action("is_chip", situation.is_chip);
  action("is_on_target", situation.path.is_on_target);
  action("path_s", situation.path.time_s);
  action("keeper_to_path_m", situation.keeper_to_path_m);
  action("others_to_path_m", situation.others_to_path_m);
}

std::string header() {
  io::Cells names;
  KeptShot shot;
  for_each_column(shot, [&](const char* name, const auto&) { names.emplace_back(name); });
  return io::csv_line(names) + "\n";
}

std::string line_of(const KeptShot& shot) {
  io::Cells cells;
  for_each_column(shot, [&](const char*, const auto& value) {
    if constexpr (std::is_same_v<std::decay_t<decltype(value)>, bool>) {
      cells.emplace_back(value ? "1" : "0");
    } else {
      cells.push_back(fmt::format("{}", value));
    }
  });
  return io::csv_line(cells) + "\n";
}

// Nullopt if the line is not a shot.
std::optional<KeptShot> shot_in(std::string_view line) {
  const std::optional<io::Cells> cells = io::csv_cells(line);
  if (!cells) return std::nullopt;
  KeptShot shot;
  std::size_t column = 0;
  bool is_complete = true;
  for_each_column(shot, [&](const char*, auto& value) {
    std::istringstream cell(column < cells->size() ? (*cells)[column] : "");
    ++column;
    is_complete &= cell >> value && cell.peek() == std::istringstream::traits_type::eof();
  });
  if (!is_complete || column != cells->size()) return std::nullopt;
  return shot;
}

class ShotLines final : public GameText {
 public:
  explicit ShotLines(const game::GameConfiguration& game) : game_(game) {}

  void on_shot(const game::Shot& shot) override {
    if (!shot.situation) return;
    const auto name_of_team = [&](Side side) { return game::team_on(game_, side).strategy; };
    text_ += line_of({name_of_team(shot.team), name_of_team(opponent_of(shot.team)),
                      shot.has_scored, *shot.situation});
  }
  std::string text(const game::GameRecord& /*record*/) const override {
    return text_ + std::string(kEndOfGame);
  }

 private:
  const game::GameConfiguration& game_;
  std::string text_;
};

// The first `count` shots among these lines that are for this purpose. Errors name the text and the
// line, counted after its header.
std::vector<KeptShot> shots_in(std::string_view text, Purpose purpose, std::size_t count,
                               const std::string& name) {
  std::vector<KeptShot> shots;
  int number = 0;
  for (const std::string_view line : io::complete_lines(text)) {
    if (shots.size() == count) break;
    ++number;
    std::optional<KeptShot> shot = shot_in(line);
    if (!shot) throw std::runtime_error(fmt::format("{}: row {} is not a shot", name, number));
    if (purpose == Purpose::kFit || shot->team == kLeftOut) shots.push_back(std::move(*shot));
  }
  return shots;
}

}  // namespace

std::vector<KeptShot> shots_under(const std::string& rules, Purpose purpose, std::size_t count,
                                  const std::filesystem::path& folder) {
  const std::filesystem::path file =
      folder / fmt::format("{}-{}.csv", rules, purpose == Purpose::kTest ? "test" : "fit");
  const std::string first_line = header();
  if (const std::optional<std::string> text = io::read_file(file)) {
    if (text->rfind(first_line, 0) != 0) {
      throw std::runtime_error(
          fmt::format("{} has different columns; delete it and run again", file.string()));
    }
    const std::string_view lines = std::string_view(*text).substr(first_line.size());
    std::vector<KeptShot> kept = shots_in(lines, purpose, count, file.string());
    if (kept.size() == count) return kept;
  }
  const auto make = [](const game::GameConfiguration& game) {
    return std::make_unique<ShotLines>(game);
  };
  std::string lines;
  std::vector<KeptShot> shots;
  for (std::size_t batch = 0; shots.size() < count; ++batch) {
    if (batch == kMostBatches) throw std::runtime_error("too few shots under the rules " + rules);
    std::string played;
    for (const std::string& text : texts_of_batch(rules, purpose, batch, make))
      played.append(text, 0, text.size() - kEndOfGame.size());
    for (KeptShot& shot : shots_in(played, purpose, count - shots.size(), "a game"))
      shots.push_back(std::move(shot));
    lines += played;
  }
  io::PendingFile(file).commit(first_line + lines);
  return shots;
}

}  // namespace autoref::tools
