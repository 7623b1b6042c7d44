// Checks that a comparison names the right reason: cobalt plays against a cobalt with a planted
// weakness, and the most certain part of the difference is printed.
//
//   planted_causes [GAMES]     GAMES per weakness; default: 100
#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <numeric>
#include <optional>
#include <string>
#include <vector>

#include "experiments/analysis/difference_parts.hpp"
#include "experiments/analysis/play_differences.hpp"
#include "experiments/kinds/compare/parts_report.hpp"
#include "experiments/kinds/compare/play_report.hpp"
#include "io/table.hpp"
#include "tools/planted/planted_change.hpp"

namespace autoref::tools {
namespace {

// All robots stand still while the team should take a free kick near the opponents' corners.
void without_corner_kicks(const strategies::Strategy& /*team*/, const TeamView& view,
                          const Field& field, TeamCommands& commands) {
  constexpr double kNear_m = 0.5;
  const Vec2 ball_m = view.ball.position_m;
  const bool is_free_kick = view.play == Play::kDirectFree || view.play == Play::kIndirectFree;
  const bool is_in_corner = ball_m.x() > field.half_length_m() - kNear_m &&
                            std::abs(ball_m.y()) > field.half_width_m() - kNear_m;
  if (view.ours && is_free_kick && is_in_corner) commands = {};
}

std::vector<PlantedChange> all_causes() {
  return {{"takes no corner kicks", without_corner_kicks, {}},
          slow_keeper(),
          never_passes(),
          {"no weakness", {}, {}}};
}

// The report's lines and tables of reasons.
std::string reasons_after(const PlantedChange& cause, int pairs) {
  const experiments::Comparison comparison = comparison_of(cause, pairs);
  const experiments::RowsById rows = play_all(comparison, cause.change);
  std::vector<int> numbers(static_cast<std::size_t>(pairs));
  std::iota(numbers.begin(), numbers.end(), 1);
  const std::vector<experiments::PairedOpponent> opponents = {
      {matchup_of(comparison), std::nullopt}};
  const auto parts = experiments::difference_parts(opponents, numbers, rows);
  const auto play = experiments::play_differences(opponents, numbers, rows);
  std::string text = fmt::format("{}\n\n{}\n\n{}", experiments::most_certain_text(parts),
                                 experiments::most_certain_text(play),
                                 io::text_of(experiments::parts_table(parts, false)));
  if (const io::TextBlocks table = experiments::play_table(play); !table.empty())
    text += "\n" + io::text_of(table);
  return text;
}

int main_of(int games) {
  fmt::print(
      "# Planted weaknesses\n\n{} games of cobalt with each weakness (new) against cobalt without "
      "it (old), rules 2026-b.\n\n",
      games);
  for (const PlantedChange& cause : all_causes()) {
    fmt::print("## {}\n\n{}\n", cause.name, reasons_after(cause, games / 2));
    std::fflush(stdout);
  }
  return 0;
}

}  // namespace
}  // namespace autoref::tools

int main(int argc, char** argv) try {
  const int games = argc > 1 ? std::atoi(argv[1]) : 100;
  return games < 2 ? 2 : autoref::tools::main_of(games);
} catch (const std::exception& error) {
  std::fprintf(stderr, "planted_causes: %s\n", error.what());
  return 1;
}
