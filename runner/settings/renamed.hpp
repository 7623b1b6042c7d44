// Names from earlier versions that users' files may still contain.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace autoref::runner {

// The current name of a setting, rule or event; nullopt if it was not renamed.
std::optional<std::string_view> new_name_of(std::string_view old_name);

// The current name of a verb of `autoref`, or of a kind of scenario; nullopt if it was not renamed.
std::optional<std::string_view> new_verb_of(std::string_view old_verb);
std::optional<std::string_view> new_kind_of(std::string_view old_kind);

// "unknown key 'crash'; its name is 'bot_crash_unique' now".
std::string renamed_message(std::string_view old_name, std::string_view new_name);

}  // namespace autoref::runner
