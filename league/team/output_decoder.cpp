#include "league/team/output_decoder.hpp"

#include "league/team/team_fault.hpp"

namespace autoref::league {

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
