// The verb that prints the manual's reference pages.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "app/command_line.hpp"
#include "app/description/reference_pages.hpp"
#include "app/one_of.hpp"
#include "io/errors.hpp"

namespace autoref::app {

void add_reference_verb(CLI::App& app, Chosen& chosen) {
  CLI::App* verb = app.add_subcommand("reference", "Print a page of the manual's reference.");
  auto page = std::make_shared<std::string>();
  verb->add_option("PAGE", *page,
                   fmt::format("One of {}.", fmt::join(reference_page_names(), ", ")))
      ->required()
      ->check(one_of(reference_page_names()));
  verb->footer("Example:\n  autoref reference settings > docs/reference/settings.md");
  verb->callback([&app, page, &chosen] {
    chosen = [&app, page] {
      fmt::print("{}", reference_page(*page, described(app)));
      return static_cast<int>(io::kDone);
    };
  });
}

}  // namespace autoref::app
