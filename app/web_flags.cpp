#include "app/web_flags.hpp"

#include "live/web/web_request.hpp"

namespace autoref::app {

void add_web_flags(CLI::App& verb, WebFlags& flags, const std::string& help) {
  CLI::Option* web = verb.add_option("--web", flags.address, help)->type_name("[ADDRESS:]PORT");
  verb.add_option("--web-host", flags.hosts,
                  "With --web: also answer browsers that know this computer as NAME, such as "
                  "laptop.local; repeatable.")
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

}  // namespace autoref::app
