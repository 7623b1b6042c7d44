// Names that users' files may still hold from earlier versions.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace autoref::runner {

// What a setting, a rule or an event is called today; none for a name that was not changed.
std::optional<std::string_view> new_name_of(std::string_view old_name);

// What a verb of `autoref`, or a kind of scenario, is called today; none for one that was not
// changed.
std::optional<std::string_view> new_verb_of(std::string_view old_verb);
std::optional<std::string_view> new_kind_of(std::string_view old_kind);

// "unknown key 'crash'; its name is 'bot_crash_unique' now".
std::string renamed_message(std::string_view old_name, std::string_view new_name);

}  // namespace autoref::runner
