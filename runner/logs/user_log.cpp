#include "runner/logs/user_log.hpp"

#include <fmt/format.h>

#include "runner/io/errors.hpp"

namespace autoref::runner {
std::string damage_text(const std::string& path, const league::LogSummary& log) {
  std::string text;
  if (log.damage) {
    text = fmt::format("autoref: {}: the log is read up to byte {}: {}\n", path, log.damage->offset,
                       log.damage->what);
  }
  if (log.unreadable > 0) {
    text += fmt::format(
        "autoref: {}: {} messages make no sense and are left out, the first at "
        "byte {}\n",
        path, log.unreadable, log.unreadable_at);
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
  throw InputError({path}, "", "the log shows no frame of the field: nothing can be seen");
}

}  // namespace autoref::runner
