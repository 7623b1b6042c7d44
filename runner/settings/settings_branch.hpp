// Helpers to write down the list of settings, used only by fields.cpp and world_fields.cpp.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "runner/settings/fields.hpp"

namespace autoref::runner {

// Collects the settings of one branch.
class Branch {
 public:
  Branch(std::vector<Setting>& list, std::string path) : list_(list), path_(std::move(path)) {}

  template <typename T>
  void number(std::string_view name, T& value, Range range, std::string_view unit,
              std::string_view about) {
    list_.push_back({path_ + std::string(name), &value, range, {}, unit, about});
  }

  template <typename T>
  void word(std::string_view name, T& value, std::vector<std::string> words,
            std::string_view about) {
    list_.push_back({path_ + std::string(name), &value, {}, std::move(words), "", about});
  }

  void yes_or_no(std::string_view name, bool& value, std::string_view about) {
    list_.push_back({path_ + std::string(name), &value, {}, {"false", "true"}, "", about});
  }

  void add(std::string_view name, Target target, Range range, std::string_view about) {
    list_.push_back({path_ + std::string(name), std::move(target), range, {}, "", about});
  }

  void preset(std::string_view name, Target target, std::vector<std::string> words,
              std::string_view about) {
    list_.push_back(
        {path_ + std::string(name), std::move(target), {}, std::move(words), "", about});
  }

  Branch below(const std::string& name) const { return {list_, path_ + name + "."}; }

 private:
  std::vector<Setting>& list_;
  std::string path_;
};

// Greater than 0 and at most `high`.
constexpr Range positive(double high) { return {0, high, true}; }

}  // namespace autoref::runner
