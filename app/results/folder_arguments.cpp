#include "app/results/folder_arguments.hpp"

#include <CLI/CLI.hpp>

namespace autoref::app {

void add_folder_options(CLI::App& verb, FolderArguments& arguments) {
  verb.add_option("DIR", arguments.folder, "Results folder, as written by run, compare or judge.")
      ->required();
  verb.add_option("--build", arguments.build,
                  "Count only this build's games, if the folder holds games of several.")
      ->type_name("BUILD");
}

}  // namespace autoref::app
