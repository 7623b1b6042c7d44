// Errors that know which setting is wrong.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

namespace autoref::runner {

// Thrown for settings that may each be valid alone but make no game together. what() is for people;
// the reader of a file looks up the location of path().
class SettingError : public std::invalid_argument {
 public:
  // what() is the path followed by `text`, such as ": must differ from d0" or " is 0; it must be
  // positive".
  SettingError(std::string path, std::string text)
      : std::invalid_argument(path + text), path_(std::move(path)), text_(std::move(text)) {}

  // The same error for those who know the setting by a longer path.
  SettingError below(std::string_view branch) const {
    return {std::string(branch) + "." + path_, text_};
  }

  // The setting to correct, or its branch.
  const std::string& path() const { return path_; }

 private:
  std::string path_;
  std::string text_;
};

}  // namespace autoref::runner
