#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <cmath>
#include <memory>
#include <optional>

#include "app/output_file.hpp"
#include "app/shared_options.hpp"
#include "app/verbs.hpp"
#include "io/errors.hpp"
#include "io/words.hpp"
#include "league/referee_message.hpp"
#include "logs/user_log.hpp"
#include "view/drawing.hpp"

namespace autoref::app {
namespace {

struct DrawArguments {
  std::string log;
  std::string output;
  std::string at;     // time in seconds; empty if `trace` is given
  std::string trace;  // "from:to", in seconds
  std::string rules = "paper";
};

constexpr double kLongestTrace_s = 120;  // longer traces would cover the whole field
constexpr double kDensest_s = 0.01;      // minimum interval between the frames of a trace

// A time interval; `from_s` equals `to_s` for a single instant.
struct TimeSpan {
  double from_s = 0;
  double to_s = 0;
  bool is_instant() const { return from_s == to_s; }
};

double seconds_in(const std::string& flag, const std::string& text) {
  if (const auto number = io::number_in(text)) return *number;
  throw io::InputError({flag}, "", fmt::format("'{}' is not a number of seconds", text));
}

TimeSpan trace_in(const std::string& text) {
  const std::string flag = "--trace";
  const std::size_t colon = text.find(':');
  if (colon == std::string::npos)
    throw io::InputError({flag}, "", fmt::format("'{}' is not FROM:TO, such as 80:95", text));
  const TimeSpan interval{seconds_in(flag, text.substr(0, colon)),
                          seconds_in(flag, text.substr(colon + 1))};
  if (interval.to_s <= interval.from_s)
    throw io::InputError({flag}, "", fmt::format("'{}' ends before it begins", text));
  if (interval.to_s - interval.from_s > kLongestTrace_s) {
    throw io::InputError(
        {flag}, "",
        fmt::format("'{}' is longer than {} s, the longest possible trace", text, kLongestTrace_s));
  }
  return interval;
}

TimeSpan interval_in(const DrawArguments& arguments) {
  if (arguments.at.empty() == arguments.trace.empty())
    throw io::InputError({}, "", "give either --at or --trace");
  if (arguments.at.empty()) return trace_in(arguments.trace);
  const double at_s = seconds_in("--at", arguments.at);
  return {at_s, at_s};
}

// Keeps only the frames to draw.
class Collector final : public league::LogVisitor {
 public:
  explicit Collector(const TimeSpan& interval) : interval_(interval) {}

  void on_referee(double time_s, const league::RefereePacket& packet) override {
    // Ignore signals after the interval, unless there was none before its end.
    if (time_s > interval_.to_s && game.signal) return;
    if (const auto signal = league::signal_of(packet)) game.signal = *signal;
    game.names = {{packet.yellow().name(), packet.blue().name()}};
  }

  void on_frame(const Frame& frame) override {
    if (!first_s) first_s = frame.time_s;
    last_s = frame.time_s;
    if (interval_.is_instant()) return take_nearest(frame);
    const bool is_asked = frame.time_s >= interval_.from_s && frame.time_s <= interval_.to_s;
    const bool is_dense =
        !game.frames.empty() && frame.time_s - game.frames.back().time_s < kDensest_s;
    if (is_asked && !is_dense) game.frames.push_back(frame);
  }

  view::DrawnGame game;
  std::optional<double> first_s;
  double last_s = 0;

 private:
  double distance_s(const Frame& frame) const { return std::abs(frame.time_s - interval_.from_s); }

  void take_nearest(const Frame& frame) {
    if (game.frames.empty()) game.frames.push_back(frame);
    if (distance_s(frame) < distance_s(game.frames.front())) game.frames.front() = frame;
  }

  TimeSpan interval_;
};

// Throws InputError if the log does not cover the whole interval.
void check_shown(const DrawArguments& arguments, const TimeSpan& interval,
                 const Collector& collected) {
  const double first_s = collected.first_s.value_or(0);
  const bool is_inside = interval.from_s >= first_s && interval.to_s <= collected.last_s;
  if (is_inside && !collected.game.frames.empty()) return;
  const bool is_instant = interval.is_instant();
  throw io::InputError(
      {is_instant ? "--at" : "--trace"}, "",
      fmt::format("{} is not in the log, which covers {:.3f} to {:.3f} s",
                  is_instant ? arguments.at : arguments.trace, first_s, collected.last_s));
}

int draw_verb(const DrawArguments& arguments) {
  const TimeSpan interval = interval_in(arguments);
  check_outputs({{"-o", arguments.output}}, {arguments.log});
  std::optional<io::PendingFile> file;
  open_output(file, "-o", arguments.output);
  Collector collected(interval);
  const league::LogSummary log = logs::read_user_log(arguments.log, collected);
  check_shown(arguments, interval, collected);
  collected.game.field = logs::field_shown(arguments.log, log, arguments.rules);
  file->commit(view::drawing_of(collected.game));
  return log.damage ? io::kBadInput : io::kDone;
}

}  // namespace

void add_draw_verb(CLI::App& app, Chosen& chosen) {
  CLI::App* verb = app.add_subcommand("draw", "Draw one instant or a trace of a log, as SVG.");
  auto arguments = std::make_shared<DrawArguments>();
  add_log_argument(*verb, arguments->log);
  add_output_option(*verb, arguments->output, "The SVG file.");
  verb->add_option("--at", arguments->at, "The instant, in seconds from the start of the log.")
      ->type_name("SECONDS");
  verb->add_option("--trace", arguments->trace,
                   "Draw the paths of ball and robots between two instants instead.")
      ->type_name("FROM:TO");
  add_field_option(*verb, arguments->rules);
  verb->footer(
      "Examples:\n  autoref log draw game.log.gz --at 83.2 -o frame.svg\n"
      "  autoref log draw game.log.gz --trace 80:95 -o trace.svg");
  choose(*verb, chosen, arguments, draw_verb);
}

}  // namespace autoref::app
