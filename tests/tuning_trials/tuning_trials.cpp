// Measures how many games the optimisers need on functions with a known optimum and noise like that
// of games. docs/tuning.md has its output.
//
//     tuning_trials [SEEDS]      default: 200
#include <fmt/format.h>

#include "runner/io/words.hpp"
#include "tests/runner/tune/noisy_search.hpp"

namespace autoref::runner {
namespace {

constexpr int kDefaultSeeds = 200;
constexpr int kMostSeeds = 100000;
constexpr int kBudgets[] = {500, 1000, 2000, 4000};  // games

struct Kind {
  const char* name;
  Method method;
  int pairs;
  bool against_itself;
};

constexpr Kind kSearches[] = {{"SPSA against others", Method::kSpsa, 4, false},
                              {"SPSA against itself", Method::kSpsa, 4, true},
                              {"CMA-ES against others", Method::kCmaEs, 8, false}};

void print_row(const char* name, const Loss& loss, int dimensions, const Kind& kind, int seeds) {
  std::string line = fmt::format("| {} {} | {} |", name, dimensions, kind.name);
  for (const int games : kBudgets) {
    NoisySearch search{{kind.method}, dimensions, kind.pairs, 0.2, kind.against_itself};
    search.search.iterations = games / search.games();
    const double mean = search.search.iterations < 3 ? -1 : search.mean_loss(loss, seeds);
    line += mean < 0 ? " - |" : fmt::format(" {:.2f} |", mean);
  }
  fmt::print("{}\n", line);
}

void print_table(int seeds) {
  fmt::print("| function, parameters | search |");
  for (const int games : kBudgets) fmt::print(" {} games |", games);
  fmt::print("\n|---|---|---|---|---|---|\n");
  for (const auto& [name, loss] :
       {std::pair<const char*, Loss>{"bowl", bowl}, {"valley", valley}}) {
    for (const int dimensions : {2, 4, 8}) {
      for (const Kind& kind : kSearches) print_row(name, loss, dimensions, kind, seeds);
    }
  }
}

}  // namespace
}  // namespace autoref::runner

int main(int argc, char** argv) {
  using namespace autoref::runner;
  const int seeds = argc < 2 ? kDefaultSeeds : whole_number_in(argv[1]).value_or(0);
  if (argc > 2 || seeds < 1 || seeds > kMostSeeds) {
    fmt::print(stderr, "tuning_trials: expected a number of seeds from 1 to {}\n", kMostSeeds);
    return 2;
  }
  print_table(seeds);
}
