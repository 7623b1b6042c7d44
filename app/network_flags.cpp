#include "app/network_flags.hpp"

#include <fmt/format.h>

#include <optional>

#include "io/errors.hpp"
#include "io/words.hpp"
#include "live/live_options.hpp"
#include "live/web/web_request.hpp"

namespace autoref::app {

void add_web_flags(CLI::App& verb, WebFlags& flags, const std::string& help) {
  CLI::Option* web = verb.add_option("--web", flags.address, help)->type_name("[ADDRESS:]PORT");
  verb.add_option("--web-host", flags.hosts,
                  "With --web: also accept NAME, such as laptop.local, as the name of this "
                  "computer in a browser; repeatable.")
      ->type_name("NAME")
      ->allow_extra_args(false)
      ->needs(web);
}

live::WebOptions web_options_of(const WebFlags& flags) {
  live::WebOptions options;
  options.address = live::web_address(flags.address, "--web");
  options.further_hosts = flags.hosts;
  return options;
}

std::string broadcast_of(const std::string& interface) {
  if (const std::optional<std::string> address = live::broadcast_address(interface))
    return *address;
  throw io::InputError({"--broadcast"}, "",
                       fmt::format("the interface {} has no broadcast address", interface));
}

live::Address controller_address(const std::string& text, int port) {
  const std::size_t colon = text.find(':');
  if (colon == std::string::npos) return {text, port};
  const std::optional<int> given = io::whole_number_in(text.substr(colon + 1));
  if (given && colon > 0 && *given >= 1 && *given <= 65535) return {text.substr(0, colon), *given};
  throw io::InputError({"--game-controller"}, "",
                       fmt::format("expected HOST or HOST:PORT, found '{}'", text));
}

live::Address event_address(const std::string& text) {
  if (text == "auto") return {"", live::kControllerPort};
  return controller_address(text, live::kControllerPort);
}

}  // namespace autoref::app
