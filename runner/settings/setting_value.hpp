// The value of a setting once it has been read.
#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace autoref::runner {

// A number of the setting's kind, or one of its words, such as a strategy or a rule book.
using SettingValue = std::variant<double, int, std::uint64_t, std::string>;

// As files spell it, always the same.
std::string spelt(const SettingValue& value);
std::vector<std::string> spelt(const std::vector<SettingValue>& values);
std::vector<std::vector<std::string>> spelt(const std::vector<std::vector<SettingValue>>& rows);

}  // namespace autoref::runner
