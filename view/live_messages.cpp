#include "view/live_messages.hpp"

#include <nlohmann/json.hpp>
#include <utility>

#include "io/json.hpp"
#include "view/packed_column.hpp"
#include "view/page.hpp"

namespace autoref::view {
namespace {

io::Json json_of(const LiveLimits& limits) {
  return {{"signals", limits.signals},
          {"clock", limits.clock_marks},
          {"decisions", limits.decisions},
          {"chains", limits.chains},
          {"shots", limits.shots}};
}

io::Json json_of(const std::vector<ListedGame>& games) {
  io::Json list = io::Json::array();
  for (const ListedGame& game : games)
    list.push_back({{"id", game.id}, {"text", game.text}, {"has_page", game.has_page}});
  return list;
}

// A message with only one of the lists of `part` and no frames.
CountedMessage list_message(io::Json& part, const char* list) {
  io::Json json = {{"type", "part"}, {"bytes", ""}};
  fill_recording({}, json);
  json[list] = std::move(part[list]);
  return {io::json_text(json), json[list].size()};
}

}  // namespace

std::string start_message(const PageContent& content, std::string_view id) {
  io::Json json = {{"type", "start"}, {"id", id}, {"limits", json_of(LiveLimits{})}};
  json.update(game_json(content));
  return io::json_text(json);
}

std::string part_message(const GameRecording& part) {
  io::Json json = {{"type", "part"}};
  fill_recording(part, json);
  json["bytes"] = base64_of(part.bytes());
  return io::json_text(json);
}

std::array<CountedMessage, 5> call_messages(const GameRecording& part) {
  io::Json json;
  fill_recording(part, json);
  return {list_message(json, "signals"), list_message(json, "clock"),
          list_message(json, "decisions"), list_message(json, "chains"),
          list_message(json, "shots")};
}

std::string present_message() { return io::json_text({{"type", "present"}}); }

std::string over_message(std::string_view text) {
  return io::json_text({{"type", "over"}, {"text", text}});
}

std::string run_start_message(std::string_view title) {
  return io::json_text({{"type", "start"}, {"title", title}});
}

std::string progress_message(const RunProgress& progress) {
  return io::json_text({{"type", "progress"},
                        {"done", progress.done},
                        {"total", progress.total},
                        {"text", progress.text},
                        {"remark", progress.remark}});
}

std::string results_message(std::string_view html) {
  return io::json_text({{"type", "results"}, {"html", html}});
}

std::string games_message(const std::vector<ListedGame>& running,
                          const std::vector<ListedGame>& ended) {
  return io::json_text(
      {{"type", "games"}, {"running", json_of(running)}, {"ended", json_of(ended)}});
}

}  // namespace autoref::view
