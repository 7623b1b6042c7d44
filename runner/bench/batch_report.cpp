// What `autoref bench --batch` prints.
#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <utility>

#include "runner/bench/batch_bench.hpp"
#include "runner/io/errors.hpp"
#include "runner/io/json.hpp"
#include "runner/io/table.hpp"
#include "runner/io/terminal.hpp"

namespace autoref::runner {
namespace {

std::string text_of_ratio(const MeasuredRatio& ratio) {
  return fmt::format("{:.3f} [{:.3f}, {:.3f}]", ratio.median, ratio.interval.low,
                     ratio.interval.high);
}

std::string text_of_share(const MeasuredRatio& share) {
  return fmt::format("{:.3f} % [{:.3f}, {:.3f}]", 100 * share.median, 100 * share.interval.low,
                     100 * share.interval.high);
}

TextTable crowd_table(const BatchBench& bench) {
  TextTable table{
      {{"workers", "cost of a game", "waits per game", "parent", "private MB", "resident MB"}}};
  for (const CrowdRow& row : bench.crowds) {
    table.rows.push_back(
        {std::to_string(row.workers), text_of_ratio(row.cost),
         fmt::format("{:.2f}", row.waits_per_game), fmt::format("{:.2f} %", 100 * row.parent_share),
         fmt::format("{:.2f}", row.private_mb), fmt::format("{:.2f}", row.resident_mb)});
  }
  return table;
}

void print_batch(const BatchBench& bench) {
  fmt::print("medians of {} rounds, in brackets 95 % intervals\n\n", bench.rounds);
  fmt::print("starting the program        {:9.3f} ms of processor time\n",
             1000 * bench.program_start_s);
  fmt::print("a full game                 {:9.3f} s of processor time\n", bench.full_game_s);
  fmt::print("outside its frames          {} of that\n", text_of_share(bench.overhead));
  fmt::print("  creating games            {:9.3f} %\n", 100 * bench.set_up_share);
  fmt::print("  handing out, rows         {:9.3f} %\n", 100 * bench.parent_share);
  fmt::print("a game of 10 s              {:9.3f} ms of processor time\n",
             1000 * bench.short_game_s);
  fmt::print("outside its frames          {:9.2f} %\n", 100 * bench.short_overhead);
  fmt::print("frames of games of 10 s\n  per processor second      {} of those of full games\n",
             text_of_ratio(bench.short_speed));
  fmt::print("  outside overhead          {} of those of full games\n",
             text_of_ratio(bench.short_frames));
  fmt::print("  per wall-clock second     {} of those of full games, with one worker\n\n",
             text_of_ratio(bench.short_wall));
  fmt::print("{}", table_text(crowd_table(bench), text_width(stdout)));
}

void add_ratio(Json& json, const std::string& name, const MeasuredRatio& ratio) {
  json[name] = rounded(ratio.median, 5);
  json[name + "_low95"] = rounded(ratio.interval.low, 5);
  json[name + "_high95"] = rounded(ratio.interval.high, 5);
}

Json json_of_crowd(const CrowdRow& row) {
  Json json = {{"workers", row.workers}};
  add_ratio(json, "cost_ratio", row.cost);
  json["waits_per_game"] = rounded(row.waits_per_game, 2);
  json["parent_share"] = rounded(row.parent_share, 5);
  json["private_mb"] = rounded(row.private_mb, 2);
  json["resident_mb"] = rounded(row.resident_mb, 2);
  return json;
}

std::string json_of_batch(const BatchBench& bench) {
  Json json = {{"rounds", bench.rounds}, {"full_game_s", rounded(bench.full_game_s, 5)}};
  add_ratio(json, "overhead", bench.overhead);
  json["set_up_share"] = rounded(bench.set_up_share, 6);
  json["parent_share"] = rounded(bench.parent_share, 6);
  json["short_game_s"] = rounded(bench.short_game_s, 6);
  json["short_overhead"] = rounded(bench.short_overhead, 5);
  add_ratio(json, "short_speed", bench.short_speed);
  add_ratio(json, "short_frames", bench.short_frames);
  add_ratio(json, "short_wall", bench.short_wall);
  json["program_start_s"] = rounded(bench.program_start_s, 6);
  Json crowds = Json::array();
  for (const CrowdRow& row : bench.crowds) crowds.push_back(json_of_crowd(row));
  json["crowds"] = std::move(crowds);
  return json_text(json);
}

}  // namespace

int run_batch_bench(int rounds, bool json) {
  const BatchBench bench = bench_batch("/proc/self/exe", rounds);
  if (json) {
    fmt::print("{}\n", json_of_batch(bench));
  } else {
    print_batch(bench);
  }
  return kDone;
}

}  // namespace autoref::runner
