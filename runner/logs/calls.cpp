#include "runner/logs/calls.hpp"

#include <algorithm>

namespace autoref::runner {
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

bool fits(const Call& recorded, const Call& refereed, double lead_s) {
  return recorded.restart == refereed.restart && refereed.stop_s <= recorded.restart_s &&
         refereed.restart_s >= recorded.stop_s - lead_s;
}

double time_of(const CallPair& pair) {
  return pair.recorded ? pair.recorded->stop_s : pair.refereed->stop_s;
}

double share(int part, int whole) { return whole > 0 ? static_cast<double>(part) / whole : 0; }

}  // namespace

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

// Greedy matching in order of time: each recorded call takes the first free call that fits.
Agreement agreement_of(std::span<const Call> recorded, std::span<const Call> refereed,
                       double lead_s) {
  Agreement agreement{{}, 0, static_cast<int>(recorded.size()), static_cast<int>(refereed.size())};
  std::vector<bool> is_taken(refereed.size(), false);
  std::size_t first = 0;  // calls before this index end too early to match any later recorded call
  for (const Call& call : recorded) {
    while (first < refereed.size() && refereed[first].restart_s < call.stop_s - lead_s) ++first;
    CallPair pair{call, std::nullopt};
    for (std::size_t i = first; i < refereed.size() && refereed[i].stop_s <= call.restart_s; ++i) {
      if (is_taken[i] || !fits(call, refereed[i], lead_s)) continue;
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

}  // namespace autoref::runner
