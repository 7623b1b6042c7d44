#include "runner/logs/user_log.hpp"

#include <fmt/format.h>

#include "runner/io/errors.hpp"
#include "runner/io/words.hpp"
#include "soccer/rule_book.hpp"

namespace autoref::runner {
std::string damage_text(const std::string& path, const league::LogSummary& log) {
  std::string text;
  if (log.damage) {
    text = fmt::format("autoref: {}: the log is only readable up to byte {}: {}\n", path,
                       log.damage->offset, log.damage->what);
  }
  if (log.unreadable > 0) {
    text += fmt::format(
        "autoref: {}: {} messages are invalid and ignored, the first at "
        "byte {}\n",
        path, log.unreadable, log.unreadable_at);
  }
  const auto add = [&](const std::string& line) {
    text += fmt::format("autoref: {}: {}\n", path, line);
  };
  if (log.frames_are_tracked) {
    add(fmt::format(
        "{}using the frames of its tracker{}",
        log.source == league::FrameSource::kTracker ? "" : "the log begins without vision; ",
        log.trackers > 1 ? fmt::format(" (it has {})", log.trackers) : ""));
  }
  if (log.unnumbered > 0) {
    add(fmt::format("{} detections of robots with numbers from {} are ignored", log.unnumbered,
                    kMaxRobots));
  }
  if (log.field_changes > 0)
    add(fmt::format("the field changes {} times; using the last one", log.field_changes));
  if (log.clock_restarts > 0) {
    add(fmt::format("the cameras' clock restarts {} times; adjusted to continue",
                    log.clock_restarts));
  }
  return text;
}

std::string damage_text(const std::string& path, const RecordedFacts& facts) {
  std::string text = damage_text(path, facts.log);
  const auto add = [&](const std::string& line) {
    text += fmt::format("autoref: {}: {}\n", path, line);
  };
  if (facts.unknown_signals > 0) {
    add(fmt::format("{} referee packets have an unknown stage or command and are ignored",
                    facts.unknown_signals));
  }
  if (facts.games.size() > 1) {
    add(fmt::format("the log contains {} games; the second starts at {:.1f} s", facts.games.size(),
                    facts.games[1].begins_s));
  }
  return text;
}

league::LogSummary read_user_log(const std::string& path, league::LogVisitor& visitor) {
  league::LogSummary log;
  try {
    log = league::read_log(path, visitor);
  } catch (const league::LogError& error) {
    throw InputError({}, "", error.what());
  }
  write_message(stderr, damage_text(path, log));
  if (log.frames > 0) return log;
  throw InputError({path}, "", "the log contains no vision frame: there is nothing to show");
}

Field field_shown(const std::string& path, const league::LogSummary& log, const std::string& book) {
  const std::optional<GameSetup> setup = find_game_setup(book);
  if (!setup) {
    throw InputError(
        {"--rules"}, "",
        fmt::format("unknown rule book '{}'; expected one of {}", book, listed(rule_book_names())));
  }
  if (log.field) return *log.field;
  write_message(stderr, fmt::format("autoref: {}: the log has no geometry; using the field of "
                                    "the rules {} (change with --rules)\n",
                                    path, book));
  return setup->field;
}

}  // namespace autoref::runner
