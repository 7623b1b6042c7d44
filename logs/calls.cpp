#include "logs/calls.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>

#include "io/csv.hpp"
#include "io/errors.hpp"
#include "io/words.hpp"
#include "referee/event.hpp"
#include "soccer/side.hpp"

namespace autoref::logs {
namespace {

bool is_restart(CommandKind kind) {
  switch (kind) {
    case CommandKind::kForceStart:
    case CommandKind::kPrepareKickoff:
    case CommandKind::kPreparePenalty:
    case CommandKind::kDirectFree:
    case CommandKind::kIndirectFree:
      return true;
    default:
      return false;
  }
}

bool has_same_restart(const Call& recorded, const Call& refereed) {
  return recorded.restart == refereed.restart;
}

bool has_same_event(const Call& annotated, const Call& refereed) {
  return annotated.event == refereed.event && (!annotated.side || annotated.side == refereed.side);
}

constexpr double kNearby_s = 10;

std::string text_of(const Call& call) {
  return fmt::format("{} at {:.2f} s", title_of(call), call.stop_s);
}

// The other referee's call that is nearest in time, if it is near enough.
const Call* nearest_of(std::optional<Call> CallPair::*referee, double time_s,
                       const Agreement& agreement) {
  const Call* nearest = nullptr;
  double least_s = kNearby_s;
  for (const CallPair& pair : agreement.pairs) {
    const std::optional<Call>& call = pair.*referee;
    if (!call || std::abs(call->stop_s - time_s) >= least_s) continue;
    nearest = &*call;
    least_s = std::abs(call->stop_s - time_s);
  }
  return nearest;
}

double share(int part, int whole) { return whole > 0 ? static_cast<double>(part) / whole : 0; }

// Greedy matching in order of time: each recorded call takes the first free call that fits.
// AutoRef may be `lead_s` early and `lag_s` late.
template <typename Fits>
Agreement matched(std::span<const Call> recorded, std::span<const Call> refereed, const Fits& fits,
                  double lead_s, double lag_s) {
  Agreement agreement{{}, 0, static_cast<int>(recorded.size()), static_cast<int>(refereed.size())};
  std::vector<bool> is_taken(refereed.size(), false);
  std::size_t first = 0;  // calls before this index end too early to match any later recorded call
  for (const Call& call : recorded) {
    while (first < refereed.size() && refereed[first].restart_s < call.stop_s - lead_s) ++first;
    CallPair pair{call, std::nullopt};
    for (std::size_t i = first; i < refereed.size() && refereed[i].stop_s <= call.restart_s + lag_s;
         ++i) {
      const bool is_early = refereed[i].restart_s < call.stop_s - lead_s;
      if (is_early || is_taken[i] || !fits(call, refereed[i])) continue;
      is_taken[i] = true;
      pair.refereed = refereed[i];
      ++agreement.right;
      break;
    }
    agreement.pairs.push_back(pair);
  }
  for (std::size_t i = 0; i < refereed.size(); ++i) {
    if (!is_taken[i]) agreement.pairs.push_back({std::nullopt, refereed[i]});
  }
  std::stable_sort(agreement.pairs.begin(), agreement.pairs.end(),
                   [](const CallPair& a, const CallPair& b) { return time_of(a) < time_of(b); });
  return agreement;
}

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
    refuse(file, line, fmt::format("has {} cells; expected three: time, call, side", cells.size()));
  const std::optional<double> time_s = time_in(cells[0]);
  if (!time_s)
    refuse(file, line, fmt::format("'{}' is not a time such as 83.2 or 1:23.2", cells[0]));
  const std::optional<std::string_view> event = event_in(cells[1]);
  if (!event) {
    refuse(
        file, line,
        fmt::format("unknown call '{}'{}", cells[1], io::suggestion(cells[1], names_of_calls())));
  }
  return {*time_s, *time_s, {}, *event, side_in(cells[2], file, line)};
}

}  // namespace

double time_of(const CallPair& pair) {
  return pair.recorded ? pair.recorded->stop_s : pair.refereed->stop_s;
}

std::string title_of(const Call& call) {
  if (call.event.empty()) return name_of(call.restart);
  return call.side ? fmt::format("{} ({})", call.event, colour_of(*call.side))
                   : std::string(call.event);
}

void CallMaker::add(double time_s, Command command) {
  if (command.kind == CommandKind::kStop && !stopped_s_) stopped_s_ = time_s;
  if (!is_restart(command.kind) || !stopped_s_) return;
  calls_.push_back({*stopped_s_, time_s, command});
  stopped_s_.reset();
}

double Agreement::precision() const { return share(right, refereed); }
double Agreement::recall() const { return share(right, recorded); }
// The harmonic mean of precision and recall.
double Agreement::f1() const { return share(2 * right, recorded + refereed); }

std::string other_referee_text(const CallPair& pair, const Agreement& agreement) {
  if (pair.is_right()) return "";
  const std::string_view other = pair.recorded ? "AutoRef" : "recorded";
  const auto referee = pair.recorded ? &CallPair::refereed : &CallPair::recorded;
  const Call* nearest = nearest_of(referee, time_of(pair), agreement);
  return fmt::format("{}: {}", other, nearest == nullptr ? "nothing" : text_of(*nearest));
}

Agreement agreement_of(std::span<const Call> recorded, std::span<const Call> refereed,
                       double lead_s) {
  return matched(recorded, refereed, has_same_restart, lead_s, 0);
}

Agreement agreement_with_annotations(std::span<const Call> annotated,
                                     std::span<const Call> refereed, double tolerance_s) {
  return matched(annotated, refereed, has_same_event, tolerance_s, tolerance_s);
}

std::vector<Call> annotations_in(std::string_view text, const std::string& file) {
  // The last line may lack a line break.
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
