#include "runner/view/live_messages.hpp"

#include <nlohmann/json.hpp>

#include "runner/io/json.hpp"
#include "runner/view/base64.hpp"
#include "runner/view/game_json.hpp"

namespace autoref::runner {

std::string start_message(const PageContent& content, std::string_view id) {
  Json json = {{"type", "start"}, {"id", id}};
  json.update(game_json(content));
  return json_text(json);
}

std::string part_message(const GameRecording& part) {
  Json json = {{"type", "part"}};
  fill_recording(part, json);
  json["bytes"] = base64_of(part.bytes());
  return json_text(json);
}

std::string present_message() { return json_text({{"type", "present"}}); }

std::string over_message(std::string_view text) {
  return json_text({{"type", "over"}, {"text", text}});
}

std::string table_start_message() { return json_text({{"type", "start"}}); }

std::string games_message(const std::vector<std::string>& ids) {
  return json_text({{"type", "games"}, {"ids", ids}});
}

std::string table_message(std::string_view text) {
  return json_text({{"type", "table"}, {"text", text}});
}

}  // namespace autoref::runner
