#include "io/errors.hpp"

#include <fmt/format.h>

#include <boost/system/system_error.hpp>
#include <cerrno>
#include <new>
#include <system_error>

namespace autoref::io {
namespace {

std::string message_of(const FileLocation& location, std::string_view key,
                       std::string_view message) {
  std::string text = location.file;
  if (location.line > 0) text += fmt::format(":{}:{}", location.line, location.column);
  if (!text.empty()) text += ": ";
  if (!key.empty()) text += fmt::format("{}: ", key);
  return text.append(message);
}

}  // namespace

InputError::InputError(const FileLocation& location, std::string_view key, std::string_view message)
    : std::runtime_error(message_of(location, key, message)), location_(location), key_(key) {}

InputOutputError io_error(std::string_view what, int error_number) {
  return InputOutputError(
      fmt::format("{}: {}", what, std::generic_category().message(error_number)));
}

bool is_shortage(int error_number) {
  switch (error_number) {
    case EAGAIN:
    case EDQUOT:
    case EMFILE:
    case ENFILE:
    case ENOMEM:
    case ENOSPC:
      return true;
    default:
      return false;
  }
}

std::optional<std::string> environment_failure(const std::exception& error) {
  if (dynamic_cast<const std::bad_alloc*>(&error) != nullptr) return "out of memory";
  if (dynamic_cast<const InputOutputError*>(&error) != nullptr ||
      dynamic_cast<const std::system_error*>(&error) != nullptr ||
      dynamic_cast<const boost::system::system_error*>(&error) != nullptr)
    return error.what();
  return std::nullopt;
}

void write_message(std::FILE* stream, std::string_view text) {
  // A failed write is ignored: there is nobody left to report it to.
  std::fwrite(text.data(), 1, text.size(), stream);
  std::fflush(stream);
}

}  // namespace autoref::io
