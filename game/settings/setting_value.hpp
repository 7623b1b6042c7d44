// The parsed value of a setting, and errors about settings.
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace autoref::game {

// A number of the setting's type, or one of the setting's words, such as the name of a strategy or
// of a rule book.
using SettingValue = std::variant<double, int, std::uint64_t, std::string>;

// The value's canonical text, as written to files.
std::string spelt(const SettingValue& value);
std::vector<std::string> spelt(const std::vector<SettingValue>& values);
std::vector<std::vector<std::string>> spelt(const std::vector<std::vector<SettingValue>>& rows);

// An error about a setting, which is identified by its path. Also used for settings that are valid
// individually but contradict each other. what() is the message; path() lets a reader look up the
// setting's location in its file.
class SettingError : public std::invalid_argument {
 public:
  // what() is the path followed by `text`, such as ": must differ from d0" or " is 0; it must be
  // positive".
  SettingError(std::string path, std::string text)
      : std::invalid_argument(path + text), path_(std::move(path)), text_(std::move(text)) {}

  // The same error with `branch` prepended to the path.
  SettingError below(std::string_view branch) const {
    return {std::string(branch) + "." + path_, text_};
  }

  // The setting to correct, or its branch.
  const std::string& path() const { return path_; }

 private:
  std::string path_;
  std::string text_;
};

}  // namespace autoref::game
