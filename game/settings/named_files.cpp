#include "game/settings/named_files.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <stdexcept>

#include "game/settings/yaml.hpp"
#include "io/errors.hpp"
#include "io/files.hpp"

namespace autoref::game {
namespace {

namespace fs = std::filesystem;

bool is_letter_or_digit(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
}

// If the file cannot be read, the error belongs to the setting that names it.
std::string text_of(const fs::path& file) {
  try {
    return io::read_user_file(file);
  } catch (const io::InputError& error) {
    throw std::invalid_argument(error.what());
  }
}

void add_files_in(const YAML::Node& node, const fs::path& folder, std::vector<std::string>& files) {
  std::error_code error;
  if (node.IsScalar() && is_settings_file(node.Scalar()) &&
      fs::is_regular_file(folder / node.Scalar(), error))
    files.push_back((folder / node.Scalar()).string());
  for (const auto& item : node) add_files_in(node.IsMap() ? item.second : item, folder, files);
}

}  // namespace

bool is_settings_file(std::string_view text) {
  return text.find('/') != std::string_view::npos || text.ends_with(".yaml");
}

std::vector<std::string> settings_files_in(const fs::path& file) {
  std::error_code error;
  const fs::file_status status = fs::status(file, error);
  if (fs::exists(status) && !fs::is_regular_file(status)) return {};
  const YamlFile yaml(io::read_user_file(file), file.string());
  std::vector<std::string> files;
  for (const YamlEntry& entry : yaml.top()) add_files_in(entry.value, yaml.folder(), files);
  return files;
}

NamedFile read_named_file(const std::string& given, const fs::path& folder,
                          const std::string& what) {
  const fs::path path = folder / given;
  std::string name = path.stem();
  if (const std::optional<std::string> fault = fault_in_name(name, what)) {
    throw std::invalid_argument(
        fmt::format("the {} is named after its file: {}; rename the file", what, *fault));
  }
  return {what, given, std::move(name), path.string(), text_of(path)};
}

std::optional<std::string> fault_in_name(std::string_view name, std::string_view what) {
  const bool is_word = !name.empty() && std::all_of(name.begin(), name.end(), [](char c) {
    return is_letter_or_digit(c) || c == '-' || c == '_';
  });
  if (is_word && name != kNoType) return std::nullopt;
  return fmt::format(
      "a {}'s name may only contain letters, digits, - and _, and may not be '{}'; found '{}'",
      what, kNoType, name);
}

void check_name_count(std::size_t count, std::string_view what) {
  if (count <= kMostNames) return;
  throw std::invalid_argument(
      fmt::format("there are more than {} {}s, the maximum for one game", kMostNames, what));
}

void refuse_name(const NamedFile& file) {
  throw std::invalid_argument(fmt::format("another {} is already called '{}'; rename the file {}",
                                          file.what, file.name, file.given));
}

}  // namespace autoref::game
