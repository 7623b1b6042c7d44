// A log that AutoRef judges for a table of several logs.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/referee_game.hpp"
#include "logs/log_referee.hpp"
#include "logs/recorded_facts.hpp"

namespace autoref::app {

struct JudgedLog {
  std::string log;  // a path from which it can be read again
  logs::RecordedFacts facts;
  logs::LogRefereeResult result;
};

// Judges the log as `autoref referee log --rules RULES` does; `rules` may be empty. Reports damage
// and the guessed rule book on stderr. Throws InputError if it cannot be read or judged.
JudgedLog judged_log(const std::string& path, const std::string& rules,
                     const logs::FrameWatch& watch);

// Calls `use` for each log. An InputError of a log is printed, and the next one follows. Returns
// the exit code: kBadInput if one of the logs cannot be judged or is damaged.
int for_each_log(const std::vector<std::string>& paths,
                 const std::function<bool(const std::string& path)>& use);

}  // namespace autoref::app
