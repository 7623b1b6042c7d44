#include "game/settings/setting_value.hpp"

#include "io/words.hpp"

namespace autoref::game {
namespace {

struct Speller {
  std::string operator()(double number) const { return io::text_of(number); }
  std::string operator()(int number) const { return std::to_string(number); }
  std::string operator()(std::uint64_t number) const { return std::to_string(number); }
  std::string operator()(const std::string& word) const { return word; }
};

}  // namespace

std::string spelt(const SettingValue& value) { return std::visit(Speller{}, value); }

std::vector<std::string> spelt(const std::vector<SettingValue>& values) {
  std::vector<std::string> texts;
  texts.reserve(values.size());
  for (const SettingValue& value : values) texts.push_back(spelt(value));
  return texts;
}

std::vector<std::vector<std::string>> spelt(const std::vector<std::vector<SettingValue>>& rows) {
  std::vector<std::vector<std::string>> texts;
  texts.reserve(rows.size());
  for (const std::vector<SettingValue>& row : rows) texts.push_back(spelt(row));
  return texts;
}

}  // namespace autoref::game
