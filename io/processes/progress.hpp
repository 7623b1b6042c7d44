// Reports an experiment's progress on stderr.
#pragma once

#include <chrono>
#include <cstdio>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "io/json.hpp"
#include "io/processes/standings_table.hpp"

namespace autoref::io {

struct GameCounts {
  int total = 0;
  int done = 0;                   // number of games played by this run and earlier ones
  int played = 0;                 // number of games played by this run
  std::optional<int> voids = {};  // among the games done; nullopt if not counted
};

// "1 h 05 min", "2 min 05 s", "9 s".
std::string duration_text(double seconds);

// "12/120 games   62 games/min   1 min 44 s left   0 void", `elapsed_s` after the start of this
// run. The speed is omitted until a game has been played.
std::string progress_text(const GameCounts& counts, double elapsed_s);

// Style of the progress output.
enum class ProgressStyle {
  kAuto,   // redrawn bar and tables on a terminal (unless TERM is "dumb"), otherwise kPlain
  kPlain,  // one line every few seconds
  kJson,   // a JSON object on a line every few seconds
  kNone,   // no progress, only messages
};

// Parses "plain", "json" or "none"; nullopt for other words.
std::optional<ProgressStyle> progress_style_of(std::string_view name);

// The results so far, to be shown in addition to the counts.
struct ProgressView {
  std::string heading;                // line above the tables
  std::vector<ProgressTable> tables;  // shown on a terminal
  std::shared_ptr<const Json> json;   // an object with additional members; null if there are none
};

// {"event": "progress", "done": 12, "total": 120, "void": 0, "played": 12, "elapsed_s": 11.6,
//  "games_per_min": 62.1, "left_s": 104.3}, then the view's members. Unknown numbers are null.
std::string progress_json(std::string_view event, const GameCounts& counts, double elapsed_s,
                          const ProgressView& view);

// Writes progress to a stream until destroyed; always writes the final state. Uses no colours.
class Progress {
 public:
  // Writes nothing if `stream` is null.
  explicit Progress(std::FILE* stream, ProgressStyle style = ProgressStyle::kAuto);
  Progress(std::FILE* stream, const GameCounts& counts, ProgressStyle style = ProgressStyle::kAuto);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  // Sets the numbers of games; call it again if they change. The class counts `played` itself.
  // Before the first call, only messages are written.
  void expect(const GameCounts& counts);

  // Sets what to show in addition to the counts. `view` is called at most once a second, and rarely
  // enough that it takes at most 1 % of the time.
  void show(std::function<ProgressView()> view) { view_of_ = std::move(view); }

  // Passes the counts and progress_text() to `publish` at most once a second and at the end,
  // whatever the style. If an update of the view set by show() is due, the view is updated first.
  using Publish = std::function<void(const GameCounts& counts, const std::string& text)>;
  void publish(Publish publish) { publish_ = std::move(publish); }

  void game_done(bool is_void = false);

  // Writes an update if one is due. Call it several times a second.
  void tick();

  // Writes a message on its own line; as JSON, {"event": "note", "text": "..."}.
  void say(const std::string& message);

  // Leaves the tables on the terminal at the end, not only the bar.
  void keep_tables() { keeps_tables_ = true; }

 private:
  using Clock = std::chrono::steady_clock;

  double elapsed_s() const;
  std::string bar(const Screen& screen) const;
  std::string tables(const Screen& screen) const;
  void draw();
  void write_line(std::string_view event);
  void renew_view();
  void publish_counts();
  void end();

  std::FILE* stream_;
  ProgressStyle style_;  // kAuto only on a terminal
  GameCounts counts_;
  bool is_started_ = false;
  bool keeps_tables_ = false;
  std::function<ProgressView()> view_of_;
  Publish publish_;
  ProgressView view_;
  int played_in_view_ = -1;
  int done_in_line_ = -1;
  std::string drawn_;
  Clock::time_point began_ = Clock::now();
  Clock::time_point next_view_ = began_;
  Clock::time_point next_drawing_ = began_;
  Clock::time_point next_line_ = began_;
  Clock::time_point next_publishing_ = began_;
};

}  // namespace autoref::io
