#include "app/experiment/ci_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>
#include <variant>

#include "experiments/report/document.hpp"
#include "experiments/report/run_results.hpp"
#include "io/errors.hpp"
#include "io/junit.hpp"
#include "io/table.hpp"
#include "io/words.hpp"

namespace autoref::app {
namespace {

using experiments::Block;

constexpr std::size_t kMostNamedGames = 3;
constexpr const char* kVerdictGroup = "autoref.compare";
constexpr const char* kVoidGroup = "autoref.void_games";

// "team a ended with status 1 (at 2.000 s)" as "team new ended with status 1".
std::string reason_of(const experiments::GameRow& row) {
  std::string reason = row.record.void_reason;
  const std::size_t time = reason.rfind(" (at ");
  if (time != std::string::npos && reason.ends_with(" s)")) reason.erase(time);
  for (const auto& [start, team] :
       {std::pair{"team a ", &row.team_a}, std::pair{"team b ", &row.team_b}}) {
    if (reason.starts_with(start)) return fmt::format("team {} {}", *team, reason.substr(7));
  }
  return reason;
}

io::TestOutcome outcome_of(const CiReport& report) {
  if (report.has_too_many_void) return io::TestOutcome::kError;
  return report.requirement.is_met(report.answer.verdict) ? io::TestOutcome::kPassed
                                                          : io::TestOutcome::kFailed;
}

std::size_t void_games(const CiReport& report) {
  std::size_t count = 0;
  for (const VoidProblem& problem : report.problems) count += problem.games.size();
  return count;
}

// The answer, or why it does not count.
std::string headline(const CiReport& report) {
  if (!report.has_too_many_void) return report.answer.sentence;
  return fmt::format(
      "{} of {} games are void, more than {:.0f} %, so the answer does not count: {}",
      void_games(report), report.games, 100 * io::kMostVoid, report.answer.sentence);
}

// "3 of 40 games are void: team new ended with status 1 (new-old-p0001-1, ...)".
std::string text_of(const VoidProblem& problem, const CiReport& report) {
  std::vector<std::string> named = problem.games;
  if (named.size() > kMostNamedGames) {
    named.resize(kMostNamedGames);
    named.emplace_back("...");
  }
  return fmt::format("{} of {} games are void: {} ({})", problem.games.size(), report.games,
                     problem.text, io::listed(named));
}

void append(std::vector<Block>& blocks, std::vector<Block> more) {
  std::move(more.begin(), more.end(), std::back_inserter(blocks));
}

void append_folded(std::vector<Block>& blocks, const std::string& summary,
                   std::vector<Block> more) {
  blocks.emplace_back(experiments::FoldStart{summary});
  append(blocks, std::move(more));
  blocks.emplace_back(experiments::FoldEnd{});
}

// A table without its heading, which becomes the summary of the folded block.
void append_folded(std::vector<Block>& blocks, const io::TextBlocks& table) {
  if (table.empty()) return;
  const std::string& heading = std::get<std::string>(table.front());
  append_folded(blocks, heading.substr(0, heading.find(':')),
                experiments::blocks_of({table.begin() + 1, table.end()}));
}

std::vector<Block> repeating_blocks(const CiReport& report) {
  return {experiments::List{{"rules: " + report.rules, "seed: " + report.seed,
                             "build: autoref " + report.build,
                             fmt::format("required: {} (--require {})",
                                         report.requirement.statement, report.requirement.word)}},
          experiments::Verbatim{report.command}};
}

std::string verdict_details(const CiReport& report) {
  io::TextBlocks blocks = {report.answer.reason + "\n" + report.about + "\n\n"};
  blocks.insert(blocks.end(), report.answer.opponents.begin(), report.answer.opponents.end());
  return headline(report) + "\n" + io::text_of(blocks) + "\n" + report.command + "\n";
}

}  // namespace

std::vector<VoidProblem> void_problems(const experiments::RowsById& rows) {
  std::vector<VoidProblem> problems;
  for (const auto& [id, row] : rows) {
    if (!experiments::is_void(row.record)) continue;
    std::string reason = reason_of(row);
    const auto same =
        std::find_if(problems.begin(), problems.end(),
                     [&reason](const VoidProblem& problem) { return problem.text == reason; });
    if (same != problems.end())
      same->games.push_back(id);
    else
      problems.push_back({std::move(reason), {id}});
  }
  return problems;
}

std::string comparison_markdown(const CiReport& report) {
  const bool has_passed = outcome_of(report) == io::TestOutcome::kPassed;
  experiments::Document document{report.name, {}};
  std::vector<Block>& blocks = document.blocks;
  blocks.emplace_back(experiments::Strong{
      fmt::format("{}: {}", has_passed ? "Passed" : "Failed", headline(report))});
  if (!report.answer.reason.empty())
    blocks.emplace_back(experiments::Paragraph{report.answer.reason});
  blocks.emplace_back(experiments::Paragraph{report.about});
  append(blocks, experiments::blocks_of(report.answer.opponents));
  experiments::List problems;
  for (const VoidProblem& problem : report.problems)
    problems.items.push_back(text_of(problem, report));
  if (!problems.items.empty()) blocks.emplace_back(std::move(problems));
  append_folded(blocks, report.answer.parts);
  append_folded(blocks, report.answer.play);
  append_folded(blocks, "How to repeat it", repeating_blocks(report));
  return markdown_of(document);
}

std::string comparison_junit(const CiReport& report) {
  std::vector<io::TestCase> cases = {{kVerdictGroup, report.requirement.statement,
                                      outcome_of(report), headline(report),
                                      verdict_details(report)}};
  for (const VoidProblem& problem : report.problems) {
    cases.push_back({kVoidGroup, problem.text, io::TestOutcome::kError, text_of(problem, report),
                     fmt::format("{}\nResults folder: {}; what programs print to standard error is "
                                 "in its folder stderr.\n",
                                 fmt::join(problem.games, "\n"), report.folder)});
  }
  return io::junit_xml(report.name, cases);
}

}  // namespace autoref::app
