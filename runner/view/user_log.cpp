#include "runner/view/user_log.hpp"

#include <fmt/format.h>

#include "runner/errors.hpp"

namespace autoref::runner {
namespace {

void tell_damage(const std::string& path, const league::LogSummary& log) {
  if (log.damage) {
    tell(stderr, fmt::format("autoref: {}: the log ends at byte {}, too early: {}\n", path,
                             log.damage->offset, log.damage->what));
  }
  if (log.unreadable > 0) {
    tell(stderr, fmt::format("autoref: {}: {} messages make no sense and are left out, the first "
                             "at byte {}\n",
                             path, log.unreadable, log.unreadable_at));
  }
}

}  // namespace

league::LogSummary read_user_log(const std::string& path, league::LogVisitor& visitor) {
  league::LogSummary log;
  try {
    log = league::read_log(path, visitor);
  } catch (const league::LogError& error) {
    throw InputError({}, "", error.what());
  }
  tell_damage(path, log);
  if (log.pictures > 0) return log;
  throw InputError({path}, "", "the log shows no picture of the field: nothing can be seen");
}

}  // namespace autoref::runner
