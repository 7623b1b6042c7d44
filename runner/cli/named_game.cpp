#include "runner/cli/named_game.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "runner/cli/judged_results.hpp"
#include "runner/io/errors.hpp"
#include "runner/io/words.hpp"
#include "runner/judge/judged_rows.hpp"

namespace autoref::runner {
namespace {

const ScheduledGame* find_game(const ResultFolder& folder, const std::string& id) {
  const auto game = std::find_if(folder.games.begin(), folder.games.end(),
                                 [&id](const ScheduledGame& one) { return one.id == id; });
  return game == folder.games.end() ? nullptr : &*game;
}

// The game with exactly this id of a game or fault; null if there is none.
const ScheduledGame* find_game_or_fault(const ResultFolder& folder, const std::string& id) {
  if (!is_judged(folder.scenario)) return find_game(folder, id);
  const std::optional<LookedUp> found = look_up(folder, id);
  if (!found) return find_game(folder, id);
  if (!found->fault.empty())
    write_message(stderr, fmt::format("autoref: {}: {}\n", id, found->fault));
  return find_game(folder, found->game_id);
}

std::vector<std::string> similar_ids(const ResultFolder& folder, const std::string& id,
                                     const std::string& turned) {
  std::vector<std::string> ids;
  for (const ScheduledGame& one : folder.games) ids.push_back(one.id);
  const auto begins = [&ids](const std::string& front) {
    return !front.empty() && std::any_of(ids.begin(), ids.end(), [&front](const std::string& one) {
      return one.starts_with(front);
    });
  };
  if (!begins(id) && begins(turned)) return suggested_words(turned, ids);
  std::vector<std::string> similar = suggested_words(id, ids);
  if (similar.empty() && !ids.empty()) similar.push_back(nearest_word(id, ids));
  return similar;
}

[[noreturn]] void refuse_game(const ResultFolder& folder, const std::string& id,
                              const std::string& turned) {
  const std::string where = is_judged(folder.scenario)
                                ? "The last column of faults.csv lists the ids of faults"
                                : "The first column of results.csv lists all games played";
  const std::string hint = suggestion_text(similar_ids(folder, id, turned));
  throw InputError({folder.path.string()}, "",
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

const ScheduledGame& game_named(const ResultFolder& folder, const std::string& id) {
  if (const ScheduledGame* game = find_game_or_fault(folder, id)) return *game;
  const bool has_sides = folder.scenario.experiment().row_kind() == RowKind::kScene;
  const std::string turned = has_sides ? "" : turned_id(id);
  const ScheduledGame* game = turned.empty() ? nullptr : find_game_or_fault(folder, turned);
  if (game == nullptr) refuse_game(folder, id, turned);
  write_message(stderr, fmt::format("autoref: '{}' has its teams the other way round here: {}\n",
                                    id, game->id));
  return *game;
}

}  // namespace autoref::runner
