#include "logs/calls.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "soccer/colour.hpp"

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

// The other referee's call nearest in time, if it is near.
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

}  // namespace

double time_of(const CallPair& pair) {
  return pair.recorded ? pair.recorded->stop_s : pair.refereed->stop_s;
}

std::string title_of(const Call& call) {
  if (call.event.empty()) return name_of(call.restart);
  return call.side ? fmt::format("{} ({})", call.event, colour_of(*call.side))
                   : std::string(call.event);
}

void CallMaker::take(double time_s, Command command) {
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

}  // namespace autoref::logs
