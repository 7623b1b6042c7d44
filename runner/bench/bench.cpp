#include "runner/bench/bench.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>
#include <vector>

#include "runner/game/state_hash.hpp"
#include "runner/io/json.hpp"
#include "runner/statistics/sample.hpp"
#include "sim/bare_box2d_benchmark.hpp"
#include "soccer/rule_table.hpp"
#include "strategies/registry.hpp"

namespace autoref::runner {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::array<std::string_view, kPhaseCount> kPhaseNames = {
    "camera", "referee", "team_west", "team_east", "physics", "record"};

double ns_since(Clock::time_point start) {
  return std::chrono::duration<double, std::nano>(Clock::now() - start).count();
}

// A game in which every rule of every rule book is in force.
GameConfiguration game_with_all_rules(FixedTeams teams) {
  GameConfiguration game = fixed_game(teams, 0);
  game.match.rules = *find_rule_book("2014");
  for (const RuleEntry& entry : rule_table()) game.match.rules.in_force[entry.rule] = true;
  return game;
}

// Sums up the duration of each phase of the frames.
class Shares final : public Observer {
 public:
  void on_phase(Phase ended) override {
    const Clock::time_point now = Clock::now();
    ns_[static_cast<std::size_t>(ended)] +=
        std::chrono::duration<double, std::nano>(now - last_).count();
    last_ = now;
  }

  double ns_of(Phase phase) const { return ns_[static_cast<std::size_t>(phase)]; }

  std::array<double, kPhaseCount> shares() const {
    double sum = 0;
    for (const double ns : ns_) sum += ns;
    std::array<double, kPhaseCount> shares{};
    for (int i = 0; i < kPhaseCount; ++i) shares[i] = ns_[i] / sum;
    return shares;
  }

 private:
  Clock::time_point last_ = Clock::now();
  std::array<double, kPhaseCount> ns_{};
};

double bare_ns(std::uint64_t seed, std::int64_t frames) {
  sim::BareBox2dBenchmark bare(seed);
  const Clock::time_point start = Clock::now();
  for (std::int64_t i = 0; i < frames; ++i) bare.step_frame();
  const double ns = ns_since(start);
  // Uses the result, so the compiler cannot remove the work; also fails for NaN.
  if (!(bare.checksum_m() < 1e9)) throw std::logic_error("the bare Box2D benchmark has diverged");
  return ns;
}

void print_table(const BenchResult& r) {
  fmt::print("a whole game          {:9.0f} ns per frame, {:.0f} x real time on one core\n",
             r.ns_per_frame, r.x_real_time);
  fmt::print("the bare Box2D scene  {:9.0f} ns per frame\n", r.bare_ns_per_frame);
  fmt::print("the referee           {:9.0f} ns per frame, with every rule in force\n",
             r.referee_ns_per_frame);
  fmt::print("ratio                 {:9.3f}   (median of {} rounds)\n", r.ratio, kFixedGames);
  fmt::print("signature             {:016x}\n", r.signature);
  for (int i = 0; i < kPhaseCount; ++i) {
    fmt::print("  {:10} {:5.1f} %\n", kPhaseNames[i], 100 * r.shares[i]);
  }
  for (const TeamCost& team : r.teams) {
    fmt::print("team {:16} {:9.2f} us per decision\n", team.name, team.ns_per_decision / 1000);
  }
}

}  // namespace

std::string bench_json(const BenchResult& r) {
  Json shares;
  for (int i = 0; i < kPhaseCount; ++i) shares[kPhaseNames[i]] = rounded(r.shares[i], 4);
  Json json = {{"ns_per_frame", rounded(r.ns_per_frame, 1)},
               {"referee_ns_per_frame", rounded(r.referee_ns_per_frame, 1)},
               {"bare_ns_per_frame", rounded(r.bare_ns_per_frame, 1)},
               {"ratio", rounded(r.ratio, 4)},
               {"x_real_time", rounded(r.x_real_time, 1)},
               {"signature", fmt::format("{:016x}", r.signature)},
               {"shares", std::move(shares)}};
  for (const TeamCost& team : r.teams)
    json["team_ns_per_decision"][team.name] = rounded(team.ns_per_decision, 1);
  return json_text(json);
}

BenchResult bench(FixedTeams teams) {
  std::vector<double> game_ns, bare_frame_ns, ratios;
  StateHash signature;
  for (int i = 0; i < kFixedGames; ++i) {
    const GameConfiguration game = fixed_game(teams, i);
    const Clock::time_point start = Clock::now();
    const GameRecord record = play(game);
    const auto frames = static_cast<double>(record.frames);
    game_ns.push_back(ns_since(start) / frames);
    bare_frame_ns.push_back(bare_ns(game.seed, record.frames) / frames);
    ratios.push_back(game_ns.back() / bare_frame_ns.back());
    signature.add(record.state_hash);
  }
  // The phases are measured in separate games, since reading the clock in every phase costs time.
  Shares shares;
  play(fixed_game(teams, 0), &shares);
  Shares with_all_rules;
  const GameRecord refereed = play(game_with_all_rules(teams), &with_all_rules);

  BenchResult result;
  result.ns_per_frame = median(game_ns);
  result.bare_ns_per_frame = median(bare_frame_ns);
  result.ratio = median(ratios);
  result.x_real_time = 1e9 / GameConfiguration{}.sim.frame_rate_hz / result.ns_per_frame;
  result.signature = signature.value();
  result.shares = shares.shares();
  result.referee_ns_per_frame =
      with_all_rules.ns_of(Phase::kReferee) / static_cast<double>(refereed.frames);
  return result;
}

int run_bench(FixedTeams teams, bool json) {
  BenchResult result = bench(teams);
  if (teams == FixedTeams::kPlain) {
    for (const strategies::Entry& team : strategies::all_strategies())
      result.teams.push_back(cost_of_team(team.name));
  }
  if (json) {
    fmt::print("{}\n", bench_json(result));
  } else {
    print_table(result);
  }
  return 0;
}

}  // namespace autoref::runner
