// Reads outputs in JSON, and writes flat JSON fast.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "league/team/team_messages.hpp"

namespace autoref::league {

// Appends flat JSON to a text, fast enough for messages that are sent once per frame. Members of an
// object and elements of an array are separated by commas; names and texts must not require
// escaping.
class JsonText {
 public:
  explicit JsonText(std::string& text) : text_(&text) {}

  // Opens an object or array. The name is empty for an element of an array.
  JsonText& open(char bracket, std::string_view name = {});
  JsonText& close(char bracket);

  // Doubles are written with the fewest digits, at most 17, that give the same value when read
  // back. They have a point or an exponent, so that no reader takes them for integers, which have
  // no -0.
  JsonText& member(std::string_view name, double value);
  JsonText& member(std::string_view name, std::int64_t value);
  JsonText& member(std::string_view name, int value) {
    return member(name, static_cast<std::int64_t>(value));
  }
  JsonText& member(std::string_view name, bool value);
  JsonText& member(std::string_view name, std::string_view value);
  JsonText& null(std::string_view name);

 private:
  void begin(std::string_view name);

  std::string* text_;
  bool is_first_ = true;
};

// Replaces `output` by the content of a line, which is given without its line ending. Throws
// TeamFault if the line is invalid, or contains unknown members or a member twice.
void read_json_output(std::string_view line, TeamOutput& output);

}  // namespace autoref::league
