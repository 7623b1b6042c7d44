#include "runner/cli/web_flags.hpp"

#include "runner/live/web_address.hpp"

namespace autoref::runner {

void add_web_flags(CLI::App& verb, WebFlags& flags, const std::string& help) {
  CLI::Option* web = verb.add_option("--web", flags.address, help)->type_name("[ADDRESS:]PORT");
  verb.add_option("--web-host", flags.hosts,
                  "With --web: also answer browsers that know this computer as NAME, such as "
                  "laptop.local; repeatable.")
      ->type_name("NAME")
      ->allow_extra_args(false)
      ->needs(web);
}

WebOptions web_options_of(const WebFlags& flags) {
  WebOptions options;
  options.address = web_address(flags.address, "--web");
  options.further_hosts = flags.hosts;
  return options;
}

}  // namespace autoref::runner
