// The flags for showing something in browsers.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

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

}  // namespace autoref::app
