#include "experiments/kinds/sprt/sprt_match_report.hpp"

#include <fmt/format.h>

#include "experiments/analysis/standings_report.hpp"
#include "experiments/schedule/sequential_settings.hpp"
#include "io/csv.hpp"

namespace autoref::experiments {
namespace {

std::string sentence(const SprtMatch& match, const SprtMatchState& state) {
  const Matchup matchup = matchup_of(match);
  const std::string goals =
      fmt::format("the mean lead of {} over {} in goals per game", matchup.team_a, matchup.team_b);
  switch (state.test.verdict) {
    case Verdict::kAcceptD0:
      return fmt::format("decided for d0: {} is nearer to {} than to {}", goals, match.sprt.d0,
                         match.sprt.d1);
    case Verdict::kAcceptD1:
      return fmt::format("decided for d1: {} is nearer to {} than to {}", goals, match.sprt.d1,
                         match.sprt.d0);
    case Verdict::kUndecided:
      return fmt::format("undecided whether {} is nearer to d0 = {} or to d1 = {}", goals,
                         match.sprt.d0, match.sprt.d1);
    case Verdict::kGoOn:
      break;
  }
  return fmt::format("not yet decided whether {} is nearer to d0 = {} or to d1 = {}", goals,
                     match.sprt.d0, match.sprt.d1);
}

}  // namespace

std::string name_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::kAcceptD0:
      return "d0";
    case Verdict::kAcceptD1:
      return "d1";
    case Verdict::kUndecided:
      return "undecided";
    case Verdict::kGoOn:
      break;
  }
  return "none";
}

std::string sprt_match_csv(const SprtMatch& match, const Group& matchup,
                           const SprtMatchState& state) {
  io::Cells columns = io::heads_of(matchup_columns());
  io::append(columns, {"verdict", "test_pairs", "void_pairs", "log_likelihood_ratio", "d0", "d1",
                       "alpha", "beta", "min_pairs", "max_pairs"});
  io::Cells cells = io::cells_of(matchup_columns(), matchup);
  io::append(cells, {name_of(state.test.verdict), std::to_string(state.test.pairs),
                     std::to_string(state.void_pairs),
                     fmt::format("{:.4f}", state.test.log_likelihood_ratio)});
  SequentialTest test = match.sprt;
  for (const game::Setting& setting : sprt_settings_of(test))
    cells.push_back(game::value_of(setting));
  return io::csv_line(columns) + "\n" + io::csv_line(cells) + "\n";
}

std::string verdict_text(const SprtMatch& match, const SprtMatchState& state) {
  const SequentialTest& test = match.sprt;
  std::string text = fmt::format(
      "{}\nafter {} pairs of legs (minimum {}, maximum {}): log-likelihood ratio {:+.2f}, "
      "bounds {:+.2f} and {:+.2f}\n",
      sentence(match, state), state.test.pairs, test.min_pairs, test.max_pairs,
      state.test.log_likelihood_ratio, bound_of_d0(test), bound_of_d1(test));
  if (state.void_pairs > 0) {
    text += fmt::format("the test leaves out {} pairs with a void leg\n", state.void_pairs);
  }
  return text;
}

io::TextBlocks sprt_match_table(const SprtMatch& match, const Group& matchup,
                                const SprtMatchState& state) {
  return {matchups_table({matchup}), "\n" + verdict_text(match, state)};
}

}  // namespace autoref::experiments
