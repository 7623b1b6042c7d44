#include "io/yaml_text.hpp"

#include <fmt/format.h>
#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/yaml.h>
#include <algorithm>
#include <map>
#include <sstream>
#include <vector>

namespace autoref::io {
namespace {

using YAML::anchor_t;
using YAML::Mark;

// The number of nodes to which a value expands, including the value itself, and its nesting depth.
struct Extent {
  std::int64_t nodes = 1;
  std::size_t depth = 0;
};

// Counts nodes as a reader of the document would visit them. Throws BeyondBounds.
class BoundsCheck final : public YAML::EventHandler {
 public:
  explicit BoundsCheck(const YamlBounds& bounds) : bounds_(bounds) {}

  // If the parser cannot make progress, it reports empty documents forever.
  void OnDocumentStart(const Mark& mark) override {
    if (mark.pos <= last_document_) {
      refuse(mark,
             "no value begins like this; is a '[' or '{' missing before it, or are quotes "
             "missing?");
    }
    last_document_ = mark.pos;
    anchors_.clear();
  }
  void OnDocumentEnd() override {}
  void OnNull(const Mark& mark, anchor_t anchor) override { add_leaf(mark, anchor); }
  void OnScalar(const Mark& mark, const std::string& /*tag*/, anchor_t anchor,
                const std::string& value) override {
    if (value.size() > bounds_.scalar_bytes) {
      refuse(mark, fmt::format("this text has {} bytes; at most {} can be read", value.size(),
                               bounds_.scalar_bytes));
    }
    add_leaf(mark, anchor);
  }
  void OnAlias(const Mark& mark, anchor_t anchor) override {
    const auto found = anchors_.find(anchor);
    if (found == anchors_.end()) {
      refuse(mark,
             "this alias (*) is inside the value it refers to, which would never end; "
             "write out what is meant instead");
    }
    // Adds the anchor's extent without expanding it, so nested aliases that would grow
    // exponentially ("billion laughs") are refused in time linear in the text.
    add(mark, found->second);
  }
  void OnSequenceStart(const Mark& mark, const std::string& /*tag*/, anchor_t anchor,
                       YAML::EmitterStyle::value /*style*/) override {
    open(mark, anchor);
  }
  void OnSequenceEnd() override { close(); }
  void OnMapStart(const Mark& mark, const std::string& /*tag*/, anchor_t anchor,
                  YAML::EmitterStyle::value /*style*/) override {
    open(mark, anchor);
  }
  void OnMapEnd() override { close(); }

 private:
  struct Open {
    Mark mark;
    anchor_t anchor;
    Extent extent;
  };

  [[noreturn]] static void refuse(const Mark& mark, std::string message) {
    throw BeyondBounds{mark.line + 1, mark.column + 1, std::move(message)};
  }

  void open(const Mark& mark, anchor_t anchor) {
    open_.push_back({mark, anchor, {}});
    check_depth(mark, open_.size());
  }

  void close() {
    const Open done = open_.back();
    open_.pop_back();
    keep(done.anchor, done.extent);
    add(done.mark, done.extent);
  }

  void add_leaf(const Mark& mark, anchor_t anchor) {
    keep(anchor, {});
    add(mark, {});
  }

  void keep(anchor_t anchor, const Extent& extent) {
    if (anchor != YAML::NullAnchor) anchors_[anchor] = extent;
  }

  // Adds `extent` to the innermost open list or mapping.
  void add(const Mark& mark, const Extent& extent) {
    check_depth(mark, open_.size() + extent.depth);
    if (open_.empty()) return;
    Extent& whole = open_.back().extent;
    whole.nodes += extent.nodes;
    whole.depth = std::max(whole.depth, extent.depth + 1);
    if (whole.nodes <= bounds_.nodes) return;
    refuse(mark,
           fmt::format("there are more than {} values up to here, counting those that aliases (*) "
                       "repeat; write fewer, or leave the aliases out",
                       bounds_.nodes));
  }

  void check_depth(const Mark& mark, std::size_t depth) const {
    if (depth <= bounds_.depth) return;
    refuse(mark, fmt::format("lists and mappings are nested more than {} deep; is one "
                             "not closed before this?",
                             bounds_.depth));
  }

  YamlBounds bounds_;
  int last_document_ = -1;  // byte at which the last document starts
  std::vector<Open> open_;
  std::map<anchor_t, Extent> anchors_;  // completed anchors of this document
};

}  // namespace

std::string quoted_scalar(const std::string& text) {
  YAML::Emitter emitter;
  emitter << YAML::DoubleQuoted << text;
  return emitter.c_str();
}

std::optional<BeyondBounds> beyond_bounds(const std::string& text, const YamlBounds& bounds) {
  if (text.size() > bounds.bytes) {
    return BeyondBounds{
        0, 0,
        fmt::format("the text has {} bytes; at most {} can be read", text.size(), bounds.bytes)};
  }
  std::istringstream stream(text);
  YAML::Parser parser(stream);
  BoundsCheck check(bounds);
  try {
    while (parser.HandleNextDocument(check)) {
    }
  } catch (const BeyondBounds& beyond) {
    return beyond;
  }
  return std::nullopt;
}

}  // namespace autoref::io
