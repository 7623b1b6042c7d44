// Options that say where on the network something is shown, sent or commanded.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "live/network/network.hpp"
#include "live/web/web_server.hpp"

namespace autoref::app {

struct WebFlags {
  std::string address;             // --web (live/web/web_request.hpp); empty: nothing is shown
  std::vector<std::string> hosts;  // --web-host
};

// Adds --web, explained by `help`, and --web-host.
void add_web_flags(CLI::App& verb, WebFlags& flags, const std::string& help);

// Throws InputError naming --web.
live::WebOptions web_options_of(const WebFlags& flags);

// The address of --broadcast. Throws InputError if the interface has none.
std::string broadcast_of(const std::string& interface);

// The game controller at "HOST" or "HOST:PORT", with `port` unless the text has one. Throws
// InputError naming --game-controller.
live::Address controller_address(const std::string& text, int port);

}  // namespace autoref::app
