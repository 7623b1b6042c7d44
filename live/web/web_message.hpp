// Messages to watchers of a game.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace autoref::live {

// The text of a message, shared by all watchers to which it is sent.
using WebText = std::shared_ptr<const std::string>;

// Maximum total length of the messages waiting for one watcher or for the network's thread.
inline constexpr std::size_t kMostWaiting_bytes = 4 << 20;

struct WebMessage {
  WebText text;
  bool is_frame = false;    // may be left out for a slow watcher
  std::int64_t number = 0;  // counts messages from 1
};

// The messages that a new watcher gets first.
struct WebBacklog {
  std::vector<WebText> texts;
  std::int64_t last_number = 0;  // number of the last message included
};

// The content that a server shows.
struct WebContent {
  std::string page;
  std::function<WebBacklog()> backlog;
  // The page of a game; nullopt if there is no game with that id.
  std::function<std::optional<std::string>(const std::string& id)> game_page = {};
};

}  // namespace autoref::live
