#include "benchmarks/build_comparison.hpp"

#include <fmt/format.h>

#include <charconv>
#include <nlohmann/json.hpp>
#include <optional>
#include <string_view>

#include "game/loop/state_hash.hpp"
#include "io/command.hpp"
#include "io/errors.hpp"
#include "io/files.hpp"
#include "io/json.hpp"

namespace autoref::benchmarks {
namespace {

constexpr std::size_t kShownOutput = 60;  // number of bytes that are shown of an unexpected output

io::InputError build_error(const std::string& program, std::string_view message) {
  return io::InputError({program}, "", message);
}

std::optional<std::uint64_t> hash_in(const std::string& text) {
  std::uint64_t hash = 0;
  const char* end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, hash, 16);
  if (error != std::errc() || rest != end || text.size() != 16) return std::nullopt;
  return hash;
}

// Plays the fixed games with one program.
class MeasuredProgram {
 public:
  MeasuredProgram(const std::string& program, std::string scenario, double longest_s)
      : program_(program), scenario_(std::move(scenario)), longest_s_(longest_s) {}

  // Returns the processor time per simulated second.
  double play(int round) {
    const std::string seed = std::to_string(game::fixed_seed(round));
    const std::optional<io::CommandResult> result =
        io::run_command({program_, "play", scenario_, "--seed", seed, "--json"}, longest_s_);
    if (!result) throw build_error(program_, "this program cannot be found");
    if (result->is_late)
      throw build_error(program_, fmt::format("a game took longer than {} s", longest_s_));
    if (result->code != 0)
      throw build_error(program_, fmt::format("`play` ended with code {}", result->code));
    last_ = measured_game(program_, result->out, result->processor_s);
    return last_.processor_s_per_sim_s;
  }

  // Must be called after the game of `round`.
  void end_round(int round, double mean_s) {
    speeds_.push_back(1 / mean_s);
    if (round < game::kFixedGames) signature_.add(last_.state_hash);
  }

  MeasuredBuild result() const {
    return {last_.build, experiments::median(speeds_), signature_.value()};
  }

 private:
  const std::string& program_;
  std::string scenario_;
  double longest_s_;
  MeasuredGame last_;
  std::vector<double> speeds_;
  game::StateHash signature_;
};

std::string fixed_scenario(const std::string& team) {
  return fmt::format(
      "schema: 1\nkind: game\nteams: {{ a: {{ strategy: {0} }}, b: {{ strategy: {0} }} }}\n", team);
}

void print_build(std::string_view name, const MeasuredBuild& build) {
  fmt::print("{:21} {:9.0f} x real time per processor, signature {:016x}, build {}\n", name,
             build.x_real_time, build.signature, build.build);
}

}  // namespace

MeasuredGame measured_game(const std::string& program, const std::string& text,
                           double processor_s) {
  const auto unexpected = [&] {
    return build_error(program,
                       fmt::format("expected what `autoref play --json` prints, found '{}'",
                                   text.substr(0, kShownOutput)));
  };
  const io::Json json = io::Json::parse(text, nullptr, false);
  if (!json.is_object()) throw unexpected();
  const io::Json hash = json.value("state_hash", io::Json());
  const io::Json sim_s = json.value("sim_s", io::Json());
  const io::Json status = json.value("status", io::Json());
  if (!hash.is_string() || !sim_s.is_number() || !status.is_string()) throw unexpected();
  if (status != "ok")
    throw build_error(program, "a game is void: " + text.substr(0, text.find('\n')));
  const std::optional<std::uint64_t> state_hash = hash_in(hash.get<std::string>());
  if (!state_hash || !(sim_s.get<double>() > 0) || !(processor_s > 0)) throw unexpected();
  const io::Json build = json.value("build", io::Json());
  return {processor_s / sim_s.get<double>(), *state_hash,
          build.is_string() ? build.get<std::string>() : "unknown"};
}

BuildComparison compare_builds(const std::string& before, const std::string& after,
                               const Options& options, double longest_game_s) {
  const io::WorkingFolder folder;
  const std::string scenario = (folder.path() / "game.yaml").string();
  io::replace_file(scenario, fixed_scenario(options.team()));
  MeasuredProgram a(before, scenario, longest_game_s);
  MeasuredProgram b(after, scenario, longest_game_s);
  BuildComparison comparison;
  for (int i = 0; i < options.rounds; ++i) {
    MeasuredProgram& outer = i % 2 == 0 ? a : b;
    MeasuredProgram& inner = i % 2 == 0 ? b : a;
    double outer_s = outer.play(i);
    double inner_s = inner.play(i);
    inner_s = (inner_s + inner.play(i)) / 2;
    outer_s = (outer_s + outer.play(i)) / 2;
    outer.end_round(i, outer_s);
    inner.end_round(i, inner_s);
    comparison.ratios.push_back(i % 2 == 0 ? inner_s / outer_s : outer_s / inner_s);
  }
  comparison.before = a.result();
  comparison.after = b.result();
  comparison.ratio = measured_ratio(comparison.ratios);
  return comparison;
}

void print_build_comparison(const std::string& before, const std::string& after,
                            const Options& options) {
  const BuildComparison comparison = compare_builds(before, after, options);
  print_build("before", comparison.before);
  print_build("after", comparison.after);
  for (std::size_t i = 0; i < comparison.ratios.size(); ++i)
    fmt::print("round {:<15} {:9.3f}\n", i + 1, comparison.ratios[i]);
  const MeasuredRatio& ratio = comparison.ratio;
  fmt::print(
      "ratio                 {:9.3f}   (after / before, median of {} rounds, 95 % interval {:.3f} "
      "to {:.3f})\n",
      ratio.median, options.rounds, ratio.interval.low, ratio.interval.high);
  if (!comparison.plays_same_games())
    fmt::print("The builds play different games, so part of the ratio may be due to the games.\n");
}

}  // namespace autoref::benchmarks
