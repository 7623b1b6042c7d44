#include "runner/judge/judge_games.hpp"

#include <numeric>

#include "runner/io/errors.hpp"
#include "runner/processes/progress.hpp"
#include "runner/processes/workers.hpp"

namespace autoref::runner {

std::vector<CallEvaluation> judge_games(const std::vector<JudgeGame>& games, int workers,
                                        std::FILE* stream) {
  std::vector<CallEvaluation> judgements(games.size());
  std::vector<std::size_t> jobs(games.size());
  std::iota(jobs.begin(), jobs.end(), std::size_t{0});
  Progress progress(stream, {.total = static_cast<int>(games.size())});
  WorkerOptions options;
  options.workers = workers;
  std::size_t judged = 0;
  const auto done = [&](const JobResult& result) {
    ++judged;
    if (result.failure.empty()) {
      judgements[result.job] = evaluation_in(result.payload);
    } else {
      judgements[result.job].void_reason = result.failure;
    }
    progress.game_done(games[result.job].id);
  };
  const WorkerCalls calls{
      [&games](std::size_t i) { return text_of(evaluate_calls(games[i].configuration)); }, done,
      [&progress] { progress.tick(); }};
  do_jobs(jobs, options, calls);
  if (judged < games.size()) throw Interrupted();
  return judgements;
}

}  // namespace autoref::runner
