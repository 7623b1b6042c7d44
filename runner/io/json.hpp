// Writing JSON: just what the command line prints.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace autoref::runner {

// `text` in quotes, escaped; also a valid double-quoted YAML scalar.
std::string json_text(std::string_view text);

// The shortest spelling that reads back equal; null for what is not finite.
std::string json_number(double number);

std::string json_list(const std::vector<std::string>& values);

// An object on one line, its keys in the order in which they are added. Values are JSON already.
class JsonObject {
 public:
  JsonObject& add(std::string_view key, std::string_view value);
  std::string text() const { return "{" + members_ + "}"; }

 private:
  std::string members_;
};

}  // namespace autoref::runner
