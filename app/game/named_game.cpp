#include "app/game/named_game.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "app/experiment/judged_results.hpp"
#include "io/errors.hpp"
#include "io/words.hpp"
#include "judge/judged_rows.hpp"

namespace autoref::app {
namespace {

const experiments::ScheduledGame* find_game(const experiments::ResultFolder& folder,
                                            const std::string& id) {
  const auto game =
      std::find_if(folder.games.begin(), folder.games.end(),
                   [&id](const experiments::ScheduledGame& one) { return one.id == id; });
  return game == folder.games.end() ? nullptr : &*game;
}

// The game with exactly this id of a game or fault; null if there is none.
const experiments::ScheduledGame* find_game_or_fault(const experiments::ResultFolder& folder,
                                                     const std::string& id) {
  if (!is_judged(folder.scenario)) return find_game(folder, id);
  const std::optional<judge::LookedUp> found = judge::look_up(folder, id);
  if (!found) return find_game(folder, id);
  if (!found->fault.empty())
    io::write_message(stderr, fmt::format("autoref: {}: {}\n", id, found->fault));
  return find_game(folder, found->game_id);
}

std::vector<std::string> similar_ids(const experiments::ResultFolder& folder, const std::string& id,
                                     const std::string& turned) {
  std::vector<std::string> ids;
  for (const experiments::ScheduledGame& one : folder.games) ids.push_back(one.id);
  const auto begins = [&ids](const std::string& front) {
    return !front.empty() && std::any_of(ids.begin(), ids.end(), [&front](const std::string& one) {
      return one.starts_with(front);
    });
  };
  if (!begins(id) && begins(turned)) return io::suggested_words(turned, ids);
  std::vector<std::string> similar = io::suggested_words(id, ids);
  if (similar.empty() && !ids.empty()) similar.push_back(io::nearest_word(id, ids));
  return similar;
}

[[noreturn]] void refuse_game(const experiments::ResultFolder& folder, const std::string& id,
                              const std::string& turned) {
  const std::string where = is_judged(folder.scenario)
                                ? "The last column of faults.csv lists the ids of faults"
                                : "The first column of results.csv lists all games played";
  const std::string hint = io::suggestion_text(similar_ids(folder, id, turned));
  throw io::InputError(
      {folder.path.string()}, "",
      fmt::format("contains no game '{}'{} {}", id, hint.empty() ? "." : hint, where));
}

}  // namespace

std::string turned_id(const std::string& id) {
  const std::size_t tilde = id.find('~');
  if (tilde == std::string::npos) return {};
  const std::size_t before = id.find_last_of("+ ", tilde);
  const std::size_t begin = before == std::string::npos ? 0 : before + 1;
  const std::size_t pair = id.rfind("-p");
  const std::size_t end =
      std::min({id.find(' ', tilde), pair > tilde ? pair : std::string::npos, id.size()});
  return id.substr(0, begin) + id.substr(tilde + 1, end - tilde - 1) + "~" +
         id.substr(begin, tilde - begin) + id.substr(end);
}

const experiments::ScheduledGame& game_named(const experiments::ResultFolder& folder,
                                             const std::string& id) {
  if (const experiments::ScheduledGame* game = find_game_or_fault(folder, id)) return *game;
  const bool has_sides = folder.scenario.experiment().row_kind() == experiments::RowKind::kScene;
  const std::string turned = has_sides ? "" : turned_id(id);
  const experiments::ScheduledGame* game =
      turned.empty() ? nullptr : find_game_or_fault(folder, turned);
  if (game == nullptr) refuse_game(folder, id, turned);
  io::write_message(
      stderr,
      fmt::format("autoref: '{}' has its teams the other way round here: {}\n", id, game->id));
  return *game;
}

}  // namespace autoref::app
