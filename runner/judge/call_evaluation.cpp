#include "runner/judge/call_evaluation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "runner/io/csv.hpp"
#include "runner/io/words.hpp"
#include "runner/judge/truth/ground_truth_observer.hpp"
#include "runner/settings/match_rules.hpp"

namespace autoref::runner {
namespace {

using ground_truth::Call;
using ground_truth::Outcome;
using referee::Decision;

class CallEvaluator final : public Observer {
 public:
  explicit CallEvaluator(const GameConfiguration& game)
      : a_plays_(game.match.a_plays),
        observer_(game.field, rules_of(game.match), game.sim.frame_rate_hz) {}

  void on_decision(const Decision& decision) override {
    const std::optional<Call> call = ground_truth::call_of(decision);
    if (!call) return;
    calls_.push_back(*call);
    const referee::Event event = decision.finding.event;
    if (referee::entry_of(event).is_exit) exits_.push_back(decision.last_touch.side);
    if (observer_.play().is_on || referee::may_come_in_stop(event)) return;
    if (!referee::is_call(event)) return;  // a card
    evaluation_.calls_in_stop.push_back(fmt::format("{} at {:.3f} s", call->name, call->time_s));
  }

  void on_requests(const PerSide<TeamRequests>& requests) override {
    for (const Side side : kSides) observer_.name_keeper(side, requests[side].keeper);
  }

  // Comes after the frame's decisions.
  void on_frame(const Frame& /*frame*/, const RefereeSignal& signal,
                const sim::World& world) override {
    observer_.see(world, signal);
    const bool is_in_air = world.state().ball.height_m > 0;
    for (; judged_ < calls_.size(); ++judged_) calls_[judged_].is_in_air = is_in_air;
    for (const std::optional<Side>& said : exits_) evaluate_last_touch(said);
    exits_.clear();
  }

  CallEvaluation evaluation(const GameRecord& record) {
    evaluation_.verdicts = ground_truth::associate(observer_.true_events(), calls_);
    evaluation_.transitions.assign(record.transitions.begin(), record.transitions.end());
    evaluation_.void_reason = record.void_reason;
    evaluation_.state_hash = record.state_hash;
    return std::move(evaluation_);
  }

 private:
  void evaluate_last_touch(const std::optional<Side>& said) {
    if (!observer_.ball().last()) return;
    const Side side = observer_.ball().last()->robot.side;
    LastTouchTally& tally = evaluation_.last_touch[side == a_plays_ ? 0 : 1];
    ++(!said ? tally.unknown : *said == side ? tally.right : tally.wrong);
  }

  Side a_plays_;
  ground_truth::GroundTruthObserver observer_;
  std::vector<Call> calls_;
  std::size_t judged_ = 0;                  // of these, before this frame
  std::vector<std::optional<Side>> exits_;  // who touched last, as called in this frame
  CallEvaluation evaluation_;
};

// One letter before the cells of each line says what it is.
constexpr std::string_view kVerdict = "v";
constexpr std::string_view kLastTouch = "t";
constexpr std::string_view kInStop = "s";
constexpr std::string_view kTransition = "a";
constexpr std::string_view kVoid = "x";

std::string flags_of(const ground_truth::Verdict& verdict) {
  std::string flags;
  if (verdict.is_early) flags += 'e';
  if (verdict.is_borderline) flags += 'b';
  if (verdict.is_in_air) flags += 'h';
  if (verdict.is_second) flags += '2';
  return flags;
}

std::string line_of(const ground_truth::Verdict& verdict) {
  return csv_line({std::string(kVerdict), verdict.name,
                   std::to_string(static_cast<int>(verdict.outcome)), flags_of(verdict),
                   fmt::format("{:.4f}", verdict.time_s),
                   verdict.offender ? std::string(name_of(*verdict.offender)) : "",
                   fmt::format("{:.4f}", verdict.delay_s),
                   verdict.error_m ? fmt::format("{:.4f}", *verdict.error_m) : ""});
}

template <typename Value>
Value valid(const std::optional<Value>& value) {
  if (!value) throw std::invalid_argument("not the evaluation of a game");
  return *value;
}

ground_truth::Verdict verdict_in(const std::vector<std::string>& cells) {
  const auto has = [&cells](char flag) { return cells[3].find(flag) != std::string::npos; };
  ground_truth::Verdict verdict;
  verdict.name = cells[1];
  verdict.outcome = static_cast<Outcome>(valid(whole_number_in(cells[2])));
  verdict.is_early = has('e');
  verdict.is_borderline = has('b');
  verdict.is_in_air = has('h');
  verdict.is_second = has('2');
  verdict.time_s = valid(number_in(cells[4]));
  for (const Side side : kSides) {
    if (cells[5] == name_of(side)) verdict.offender = side;
  }
  verdict.delay_s = valid(number_in(cells[6]));
  verdict.error_m = number_in(cells[7]);
  return verdict;
}

void take_in(const std::vector<std::string>& cells, CallEvaluation& evaluation) {
  if (cells[0] == kVerdict && cells.size() == 8) {
    evaluation.verdicts.push_back(verdict_in(cells));
  } else if (cells[0] == kLastTouch && cells.size() == 5) {
    evaluation.last_touch[cells[1] == "a" ? 0 : 1] = {valid(whole_number_in(cells[2])),
                                                      valid(whole_number_in(cells[3])),
                                                      valid(whole_number_in(cells[4]))};
  } else if (cells[0] == kInStop && cells.size() == 2) {
    evaluation.calls_in_stop.push_back(cells[1]);
  } else if (cells[0] == kTransition && cells.size() == 2) {
    evaluation.transitions.push_back(cells[1]);
  } else if (cells[0] == kVoid && cells.size() == 2) {
    evaluation.void_reason = cells[1];
  } else {
    throw std::invalid_argument("not the evaluation of a game");
  }
}

}  // namespace

CallEvaluation evaluate_calls(const GameConfiguration& configuration, const TeamMaker& make_team) {
  CallEvaluator evaluate_calls(configuration);
  const GameRecord record = play(configuration, &evaluate_calls, make_team);
  return evaluate_calls.evaluation(record);
}

std::string text_of(const CallEvaluation& evaluation) {
  std::string text;
  const auto add = [&text](const std::vector<std::string>& cells) {
    text += csv_line(cells) + "\n";
  };
  for (const ground_truth::Verdict& verdict : evaluation.verdicts) text += line_of(verdict) + "\n";
  for (std::size_t team = 0; team < 2; ++team) {
    const LastTouchTally& tally = evaluation.last_touch[team];
    add({std::string(kLastTouch), team == 0 ? "a" : "b", std::to_string(tally.right),
         std::to_string(tally.wrong), std::to_string(tally.unknown)});
  }
  for (const std::string& call : evaluation.calls_in_stop) add({std::string(kInStop), call});
  for (const std::string& transition : evaluation.transitions)
    add({std::string(kTransition), transition});
  if (!evaluation.void_reason.empty()) add({std::string(kVoid), evaluation.void_reason});
  return text;
}

CallEvaluation evaluation_in(std::string_view text) {
  CallEvaluation evaluation;
  for (const std::string_view line : complete_lines(text)) {
    take_in(valid(csv_cells(line)), evaluation);
  }
  return evaluation;
}

}  // namespace autoref::runner
