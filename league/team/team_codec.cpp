#include "league/team/team_codec.hpp"

#include <fmt/format.h>
#include <stdexcept>

#include "league/team/team_fault.hpp"

namespace autoref::league {
namespace {

void check_name(std::string_view name, std::size_t longest) {
  if (name.size() <= longest) return;
  throw std::invalid_argument(
      fmt::format("the name '{}' has {} bytes; names sent to team programs have at most {}", name,
                  name.size(), longest));
}

}  // namespace

std::unique_ptr<TeamCodec> make_team_codec(TeamEncoding encoding) {
  switch (encoding) {
    case TeamEncoding::kJson:
      return make_json_codec();
    case TeamEncoding::kFlat:
      return make_flat_codec();
    case TeamEncoding::kLeague:
      return make_league_codec();
  }
  throw std::invalid_argument("unknown encoding");
}

void check_names(const TeamStart& start) {
  check_name(start.rules.name, kLongestName);
  for (const auto& [name, value] : start.params) check_name(name, kLongestName);
}

OutputDecoder::Result OutputDecoder::next(TeamOutput& output) {
  if (!fault_.empty()) return Result::kFault;
  try {
    const std::optional<MessageExtent> message = codec_->find_message(bytes_);
    if (!message) return Result::kNeedsMore;
    codec_->read(std::string_view(bytes_).substr(message->begin, message->size), output);
    bytes_.erase(0, message->end);
    return Result::kOutput;
  } catch (const TeamFault& fault) {
    fault_ = fault.what();
    bytes_.clear();
    return Result::kFault;
  }
}

}  // namespace autoref::league
