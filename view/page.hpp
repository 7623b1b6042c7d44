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

// A call in a recorded game, made by the recorded referee, by AutoRef, or by both.
struct ComparedCall {
  // When the recorded referee made the call, or AutoRef if only AutoRef made it.
  double time_s = 0;
  std::string recorded;  // the recorded referee's call; empty: none
  std::string autoref;   // AutoRef's call; empty: none
  std::string other;     // if only one referee made the call: the other referee's action instead
  std::optional<double> autoref_s{};  // when AutoRef made the call; nullopt: it made none
  bool operator==(const ComparedCall&) const = default;
};

// The names of all ways in which possession chains begin and end, in the order in which a page
// offers them for selection.
struct ChainKinds {
  std::vector<std::string> starts;
  std::vector<std::string> ends;
};

struct PageContent {
  const GameRecording& recording;
  Field field;
  PerSide<std::string> names;     // names of the teams; empty if unknown
  std::vector<PageFact> facts{};  // shown below the game, such as {"build", "1.0.0-..."}
  // Compared calls in order of time; nullopt: no comparison.
  std::optional<std::vector<ComparedCall>> compared{};
  // nullopt: the game is not divided into possession chains, such as one of real robots that is
  // still played.
  std::optional<ChainKinds> chain_kinds{};
};

// The page: HTML with style, script (view/page/) and the game's data.
std::string page_of(const PageContent& content);

// The text to append to a page while the game goes on: the part of the game since the page's own
// recording or the part before.
std::string page_part(const GameRecording& part);

// A page without a game, which shows the game that its server sends (live_messages.hpp).
std::string live_page();

// A page that shows the results of an experiment and its games, as sent by its server while they
// are played. `title` is text, not HTML.
std::string run_page(std::string_view title);

// The text, with those characters escaped that HTML would interpret.
std::string html_text(std::string_view text);

// A game as JSON, as the page's script reads it (view/page/recording.js): everything but the packed
// frames (GameRecording::bytes()).
io::Json game_json(const PageContent& content);

// Adds the content of the recording: the number of frames, robots, signals, clock, decisions,
// chains and shots.
void fill_recording(const GameRecording& recording, io::Json& json);

}  // namespace autoref::view
