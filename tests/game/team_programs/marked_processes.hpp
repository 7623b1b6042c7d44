// Finds the processes that a test has started, whatever their parents.
#pragma once

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

namespace autoref::game {

// Every process of a test has a mark in its environment, even one below a forked worker.
inline const std::string& marker() {
  static const std::string text = "AUTOREF_TEST_PROGRAM=" + std::to_string(getpid());
  return text;
}

inline int marked_processes() {
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator("/proc")) {
    const std::string name = entry.path().filename();
    if (name.find_first_not_of("0123456789") != std::string::npos) continue;
    std::ifstream file(entry.path() / "environ", std::ios::binary);
    std::stringstream text;
    text << file.rdbuf();
    if (text.str().find(marker()) != std::string::npos) ++count;
  }
  return count;
}

}  // namespace autoref::game
