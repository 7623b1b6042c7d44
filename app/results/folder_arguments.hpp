// Arguments of the verbs that read a results folder.
#pragma once

#include <CLI/App.hpp>
#include <string>

namespace autoref::app {

struct FolderArguments {
  std::string folder;
  std::string build;  // only this build's rows count; empty: the folder's only build
};

// Adds the folder and --build.
void add_folder_options(CLI::App& verb, FolderArguments& arguments);

}  // namespace autoref::app
