#include "view/page.hpp"

#include <nlohmann/json.hpp>
#include <stdexcept>

#include "io/json.hpp"
#include "view/base64.hpp"
#include "view/game_json.hpp"
#include "view/page_parts.hpp"

namespace autoref::view {
namespace {

// Escapes JSON for use in a script element. An unescaped "<" could end the element; in JSON, "<"
// only occurs in strings.
std::string escaped_for_script(const std::string& json) {
  std::string escaped;
  escaped.reserve(json.size());
  for (const char letter : json) {
    if (letter == '<') {
      escaped += "\\u003c";
    } else {
      escaped += letter;
    }
  }
  return escaped;
}

// Removes the template's text up to and including `mark` from `rest`; returns the part before
// `mark`.
std::string_view text_before(std::string_view mark, std::string_view& rest) {
  const std::size_t index = rest.find(mark);
  if (index == std::string_view::npos)
    throw std::logic_error("a part of the page has no placeholder");
  const std::string_view before = rest.substr(0, index);
  rest.remove_prefix(index + mark.size());
  return before;
}

// What differs between the pages.
struct PageText {
  std::string game;    // JSON
  std::string frames;  // base64
  std::string_view allowed;
  std::string style;
  std::string script;
};

std::string page_with(const PageText& text) {
  std::string_view rest = page_frame();
  std::string page(text_before("@ALLOWED@", rest));
  page.append(text.allowed).append(text_before("@STYLE@", rest));
  page.append(text.style).append(text_before("@GAME@", rest));
  page.append(escaped_for_script(text.game)).append(text_before("@FRAMES@", rest));
  page.append(text.frames).append(text_before("@SCRIPT@", rest));
  return page.append(text.script).append(rest);
}

std::string joined(std::string_view first, std::string_view second) {
  return std::string(first).append(second);
}

}  // namespace

std::string page_of(const PageContent& content) {
  return page_with({io::json_text(game_json(content)), base64_of(content.recording.bytes()), "",
                    std::string(page_style()), joined(page_script(), page_start())});
}

std::string html_text(std::string_view text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      case '\'':
        result += "&#39;";
        break;
      default:
        result += c;
    }
  }
  return result;
}

std::string run_page(std::string_view title) {
  std::string_view rest = page_run();
  const std::string safe_title = html_text(title);
  std::string page(text_before("@TITLE@", rest));
  page.append(safe_title).append(text_before("@STYLE@", rest));
  page.append(page_style()).append(page_bracket_style()).append(page_run_style());
  page.append(text_before("@TITLE@", rest)).append(safe_title);
  page.append(text_before("@SCRIPT@", rest)).append(page_run_script());
  return page.append(rest);
}

std::string live_page() {
  return page_with({"null", "", "; connect-src 'self'", joined(page_style(), page_live_style()),
                    joined(page_script(), page_live_script())});
}

}  // namespace autoref::view
