// Strict reader of one mapping: every key must be known and given once.
#pragma once

#include <yaml-cpp/yaml.h>

#include <set>
#include <stdexcept>
#include <string>

#include "soccer/geometry.hpp"

namespace autoref::referee {

// "file:line: message", with lines counted from 1.
struct CaseError : std::runtime_error {
  CaseError(const std::string& file, const YAML::Node& node, const std::string& message)
      : std::runtime_error(file + ":" + std::to_string(node.Mark().line + 1) + ": " + message) {}
};

// Reads keys one by one; finish() rejects all that were not read. All functions throw CaseError if
// something is missing or has the wrong type.
class YamlKeys {
 public:
  YamlKeys(const YAML::Node& node, std::string file) : node_(node), file_(std::move(file)) {
    if (!node_.IsMap()) throw CaseError(file_, node_, "expected a mapping");
    std::set<std::string> keys;
    for (const auto& entry : node_) {
      const std::string key = entry.first.as<std::string>();
      if (!keys.insert(key).second) throw CaseError(file_, entry.first, key + " is given twice");
    }
  }

  bool has(const std::string& key) {
    asked_.insert(key);
    return node_[key].IsDefined();
  }

  YAML::Node child(const std::string& key) {
    if (!has(key)) throw CaseError(file_, node_, key + " is missing");
    return node_[key];
  }

  std::string text(const std::string& key) { return as<std::string>(key, "a text"); }
  double number(const std::string& key) { return as<double>(key, "a number"); }
  int whole_number(const std::string& key) { return as<int>(key, "a whole number"); }
  bool yes_or_no(const std::string& key) { return as<bool>(key, "true or false"); }

  std::string text_or(const std::string& key, const std::string& otherwise) {
    return has(key) ? text(key) : otherwise;
  }
  double number_or(const std::string& key, double otherwise) {
    return has(key) ? number(key) : otherwise;
  }

  Vec2 vector(const std::string& key) {
    const YAML::Node list = child(key);
    if (!list.IsSequence() || list.size() != 2) refuse(key, "expected [x, y]");
    try {
      return {list[0].as<double>(), list[1].as<double>()};
    } catch (const YAML::Exception&) {
      refuse(key, "expected two numbers");
    }
  }

  void finish() {
    for (const auto& entry : node_) {
      const std::string key = entry.first.as<std::string>();
      if (asked_.count(key) == 0) throw CaseError(file_, entry.first, "unknown key " + key);
    }
  }

  [[noreturn]] void refuse(const std::string& key, const std::string& message) {
    throw CaseError(file_, has(key) ? node_[key] : node_, key + ": " + message);
  }

  const std::string& file() const { return file_; }
  const YAML::Node& node() const { return node_; }

 private:
  template <typename T>
  T as(const std::string& key, const std::string& kind) {
    try {
      return child(key).as<T>();
    } catch (const YAML::Exception&) {
      refuse(key, "expected " + kind);
    }
  }

  YAML::Node node_;
  std::string file_;
  std::set<std::string> asked_;
};

}  // namespace autoref::referee
