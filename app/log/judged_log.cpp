#include "app/log/judged_log.hpp"

#include <fmt/format.h>

#include "io/errors.hpp"
#include "io/files.hpp"
#include "io/terminal.hpp"
#include "logs/recorded_teams.hpp"
#include "logs/user_log.hpp"

namespace autoref::app {

JudgedLog judged_log(const std::string& path, const std::string& rules,
                     const logs::FrameWatch& watch) {
  RefereeArguments arguments;
  arguments.rules = rules;
  JudgedLog judged;
  judged.log = logs::seekable_log(path);
  judged.facts = logs::read_facts(path, judged.log);
  io::write_message(stderr, logs::damage_text(path, judged.facts));
  check_has_frames(arguments, judged.facts, path);
  const std::string book = book_of(arguments, judged.facts, path);
  std::vector<referee::Configuration> games;
  for (const logs::RecordedGame& recorded : judged.facts.games) {
    games.push_back(game::referee_configuration(
        game::resolved(game_of(arguments, book, {}, judged.facts, recorded, path))));
  }
  judged.facts.teams = logs::teams_in(judged.log, games.front().field,
                                      games.front().rules.change_ends, judged.facts.log.source);
  judged.result = logs::referee_log(judged.log, judged.facts, games, {}, watch);
  return judged;
}

int for_each_log(const std::vector<std::string>& paths,
                 const std::function<bool(const std::string& path)>& use) {
  int code = io::kDone;
  for (const std::string& path : paths) {
    try {
      if (!use(path)) code = io::kBadInput;
    } catch (const io::InputError& error) {
      io::write_message(stderr, fmt::format("autoref: {}\n", error.what()));
      code = io::kBadInput;
    }
  }
  return code;
}

}  // namespace autoref::app
