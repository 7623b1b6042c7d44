// The parsed value of a setting.
#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace autoref::game {

// A number of the setting's type, or one of its words, such as a strategy or a rule book.
using SettingValue = std::variant<double, int, std::uint64_t, std::string>;

// The canonical text of the value, as written to files.
std::string spelt(const SettingValue& value);
std::vector<std::string> spelt(const std::vector<SettingValue>& values);
std::vector<std::vector<std::string>> spelt(const std::vector<std::vector<SettingValue>>& rows);

}  // namespace autoref::game
