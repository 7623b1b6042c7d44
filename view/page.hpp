// Renders a game as a self-contained HTML page, and as the JSON that the page's script reads.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/json.hpp"
#include "soccer/field.hpp"
#include "soccer/side.hpp"
#include "view/game_recording.hpp"

namespace autoref::view {

struct PageFact {
  std::string what;
  std::string value;
};

// A call of a recorded game, made by the recorded referee, by AutoRef, or by both.
struct ComparedCall {
  double time_s = 0;     // when the recorded referee called; AutoRef's time if only it called
  std::string recorded;  // what the recorded referee called; empty: nothing
  std::string autoref;   // what AutoRef called; empty: nothing
  std::string other;     // if only one called: what the other referee did instead
  std::optional<double> autoref_s{};  // when AutoRef called; nullopt: it did not
  bool operator==(const ComparedCall&) const = default;
};

struct PageContent {
  const GameRecording& recording;
  Field field;
  PerSide<std::string> names;     // of the teams; empty if unknown
  std::vector<PageFact> facts{};  // shown below the game, such as {"build", "1.0.0-..."}
  std::optional<std::vector<ComparedCall>>
      compared{};  // in order of time; nullopt: nobody compared
};

// The page: HTML with style, script (view/page/) and the game's data.
std::string page_of(const PageContent& content);

// A page without a game, which shows the game that its server sends (live_messages.hpp).
std::string live_page();

// A page that shows the results of an experiment and its games, which its server sends while they
// are played. `title` is text, not HTML.
std::string run_page(std::string_view title);

// The text with the characters replaced that HTML would interpret.
std::string html_text(std::string_view text);

// A game as JSON, as the page's script reads it (view/page/recording.js): everything but the packed
// frames (GameRecording::bytes()).
io::Json game_json(const PageContent& content);

// Adds what the recording contains: the number of frames, robots, signals, clock and decisions.
void fill_recording(const GameRecording& recording, io::Json& json);

}  // namespace autoref::view
