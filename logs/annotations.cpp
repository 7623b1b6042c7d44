#include "logs/annotations.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "io/csv.hpp"
#include "io/errors.hpp"
#include "io/words.hpp"
#include "referee/event.hpp"
#include "soccer/colour.hpp"

namespace autoref::logs {
namespace {

constexpr std::size_t kMostAnnotations = 100'000;
constexpr std::string_view kHead = "time,call,side";

[[noreturn]] void refuse(const std::string& file, int line, const std::string& why) {
  throw io::InputError({file, line, 1}, "", why);
}

std::optional<double> time_in(std::string_view text) {
  const std::size_t colon = text.find(':');
  if (colon == std::string_view::npos) return io::number_in(text);
  const std::optional<int> minutes = io::whole_number_in(text.substr(0, colon));
  const std::optional<double> seconds = io::number_in(text.substr(colon + 1));
  if (!minutes || !seconds || *minutes < 0 || *seconds < 0 || *seconds >= 60) return std::nullopt;
  return 60.0 * *minutes + *seconds;
}

std::optional<std::string_view> event_in(std::string_view name) {
  for (const referee::EventEntry& entry : referee::event_table()) {
    if (entry.name == name && is_call(entry.event)) return entry.name;
  }
  return std::nullopt;
}

std::vector<std::string> names_of_calls() {
  std::vector<std::string> names;
  names.reserve(referee::event_table().size());
  for (const referee::EventEntry& entry : referee::event_table()) {
    if (is_call(entry.event)) names.emplace_back(entry.name);
  }
  return names;
}

std::optional<Side> side_in(std::string_view name, const std::string& file, int line) {
  if (name.empty()) return std::nullopt;
  for (const Side side : kSides) {
    if (colour_of(side) == name) return side;
  }
  refuse(file, line, fmt::format("'{}' is not a side: write yellow, blue, or nothing", name));
}

Call call_in(const io::Cells& cells, const std::string& file, int line) {
  if (cells.size() != 3)
    refuse(file, line, fmt::format("has {} cells instead of time, call, side", cells.size()));
  const std::optional<double> time_s = time_in(cells[0]);
  if (!time_s)
    refuse(file, line, fmt::format("'{}' is not a time such as 83.2 or 1:23.2", cells[0]));
  const std::optional<std::string_view> event = event_in(cells[1]);
  if (!event) {
    refuse(file, line,
           fmt::format("'{}' is none of the calls that referee/README.md lists{}", cells[1],
                       io::suggestion(cells[1], names_of_calls())));
  }
  return {*time_s, *time_s, {}, *event, side_in(cells[2], file, line)};
}

}  // namespace

std::vector<Call> annotations_in(std::string_view text, const std::string& file) {
  // The last line may lack its line end.
  const std::string ended = fmt::format("{}\n", text);
  const std::vector<std::string_view> lines = io::lines_as_written(ended);
  if (lines[0] != kHead) refuse(file, 1, fmt::format("the first line must be {}", kHead));
  if (lines.size() > kMostAnnotations) refuse(file, 1, "too many lines");
  std::vector<Call> calls;
  calls.reserve(lines.size());
  for (std::size_t i = 1; i < lines.size(); ++i) {
    const int line = static_cast<int>(i) + 1;
    if (lines[i].empty()) continue;
    const std::optional<io::Cells> cells = io::csv_cells(lines[i]);
    if (!cells) refuse(file, line, "quotes do not match");
    calls.push_back(call_in(*cells, file, line));
  }
  std::stable_sort(calls.begin(), calls.end(),
                   [](const Call& a, const Call& b) { return a.stop_s < b.stop_s; });
  return calls;
}

}  // namespace autoref::logs
