// Options for network addresses: where games are shown, where packets are sent and which game
// controller is in command.
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

// The broadcast address of the interface given by --broadcast. Throws InputError if the interface
// has no broadcast address.
std::string broadcast_of(const std::string& interface);

// The game controller at "HOST" or "HOST:PORT", with `port` unless the text contains one. Throws
// InputError naming --game-controller.
live::Address controller_address(const std::string& text, int port);

// Where the game controller takes events: like controller_address(), or "auto", for which the host
// is empty.
live::Address event_address(const std::string& text);

}  // namespace autoref::app
