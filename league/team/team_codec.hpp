// The encodings of the messages between the simulator and a team's program, and the decoding of the
// program's output as it arrives.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "league/team/greeting.hpp"
#include "league/team/team_messages.hpp"

namespace autoref::league {

// The position of a message's content in a program's output.
struct MessageExtent {
  std::size_t begin = 0;
  std::size_t size = 0;
  std::size_t end = 0;  // end of the whole message, including its delimiters
};

// Encodes and decodes messages in one encoding. A codec reuses its memory from message to message.
class TeamCodec {
 public:
  TeamCodec() = default;
  TeamCodec(const TeamCodec&) = delete;
  TeamCodec& operator=(const TeamCodec&) = delete;
  virtual ~TeamCodec() = default;

  // These functions append the message, including its delimiters, to `bytes`. All numbers must be
  // finite. They throw std::invalid_argument if the name of the rule book or of a parameter is too
  // long to be sent.
  virtual void append(const TeamStart& start, std::string& bytes) = 0;
  virtual void append(const TeamFrame& frame, std::string& bytes) = 0;
  virtual void append(const TeamEnd& end, std::string& bytes) = 0;

  // The first message in a program's output; nullopt if it is not complete. Throws TeamFault if the
  // bytes cannot begin a message or the message would be longer than kLongestOutput.
  virtual std::optional<MessageExtent> find_message(std::string_view bytes) const = 0;

  // Replaces `output` by the content of a message. Throws TeamFault if the content is invalid; in
  // that case, `output` is unspecified.
  virtual void read(std::string_view content, TeamOutput& output) = 0;
};

std::unique_ptr<TeamCodec> make_team_codec(TeamEncoding encoding);

// Create the codecs for each encoding, for use by make_team_codec().
std::unique_ptr<TeamCodec> make_flat_codec();
std::unique_ptr<TeamCodec> make_json_codec();
std::unique_ptr<TeamCodec> make_league_codec();

// Throws std::invalid_argument if a name in `start` is too long to be sent.
void check_names(const TeamStart& start);

// Collects the bytes of a program's output after its greeting, and extracts the messages. The codec
// must outlive it.
class OutputDecoder {
 public:
  enum class Result : std::uint8_t { kNeedsMore, kOutput, kFault };

  explicit OutputDecoder(TeamCodec& codec) : codec_(&codec) {}

  void add(std::string_view bytes) { bytes_.append(bytes); }

  // Extracts the next message. If it returns kOutput, `output` is that message; otherwise, `output`
  // is unspecified. After a fault, every further call returns kFault.
  Result next(TeamOutput& output);

  // The error in the output; empty unless next() has returned kFault.
  const std::string& fault() const { return fault_; }

  // The number of bytes that belong to no message extracted so far; 0 for a program that sends
  // nothing but answers.
  std::size_t bytes_left() const { return bytes_.size(); }

 private:
  TeamCodec* codec_;
  std::string bytes_;
  std::string fault_;
};

}  // namespace autoref::league
