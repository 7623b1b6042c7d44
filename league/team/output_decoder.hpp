// Decoding of a program's output as it arrives.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "league/team/team_codec.hpp"

namespace autoref::league {

// Collects the bytes of a program's output after its greeting, and takes its messages from them.
// The codec must outlive it.
class OutputDecoder {
 public:
  enum class Result : std::uint8_t { kNeedsMore, kOutput, kFault };

  explicit OutputDecoder(TeamCodec& codec) : codec_(&codec) {}

  void add(std::string_view bytes) { bytes_.append(bytes); }

  // Takes the next message. Only after kOutput, `output` is that message. After a fault every
  // further call returns kFault.
  Result next(TeamOutput& output);

  // What is wrong with the output; empty unless next() has returned kFault.
  const std::string& fault() const { return fault_; }

  // Bytes that belong to no message taken so far: a program that only answers leaves none.
  std::size_t bytes_left() const { return bytes_.size(); }

 private:
  TeamCodec* codec_;
  std::string bytes_;
  std::string fault_;
};

}  // namespace autoref::league
