#include "logs/guessed_rules.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <ctime>
#include <optional>

namespace autoref::logs {
namespace {

// Unix times of 1 January.
constexpr std::int64_t kYear2000_s = 946'684'800;
constexpr std::int64_t kYear2018_s = 1'514'764'800;
constexpr std::int64_t kYear2100_s = 4'102'444'800;
// Between single and double size (6.05 m, 8.09 m), and between Divisions B and A (9 m, 12 m).
constexpr double kDoubleSize_m = 7;
constexpr double kLongestOfB_m = 10.5;

std::optional<std::int64_t> date_of(const league::LogSummary& log) {
  const std::int64_t unix_s = log.first_ns / 1'000'000'000;
  const bool is_date = unix_s >= kYear2000_s && unix_s < kYear2100_s;
  return is_date ? std::optional(unix_s) : std::nullopt;
}

bool has_boxes(const league::LogSummary& log, const std::optional<std::int64_t>& date_s) {
  if (log.field && !log.field_gaps.defence_area)
    return log.field->defence_area.shape == DefenceArea::Shape::kBox;
  return (date_s && *date_s >= kYear2018_s) || (log.field && log.field->length_m > kLongestOfB_m);
}

std::string book_of(const league::LogSummary& log, const std::optional<std::int64_t>& date_s) {
  const double length_m = log.field ? log.field->length_m : 0;
  if (has_boxes(log, date_s)) return length_m > kLongestOfB_m ? "2026-a" : "2026-b";
  if (length_m > kDoubleSize_m) return "2014-double";
  return date_s ? "2014" : "paper";
}

}  // namespace

GuessedRules guessed_rules(const league::LogSummary& log) {
  const std::optional<std::int64_t> date_s = date_of(log);
  const std::string field =
      log.field ? fmt::format("a field of {} x {} m", log.field->length_m, log.field->width_m)
                : "an unknown field";
  const std::string date =
      date_s ? fmt::format("recorded on {:%Y-%m-%d}", fmt::gmtime(*date_s)) : "without a date";
  return {book_of(log, date_s), field + ", " + date};
}

}  // namespace autoref::logs
