// Parameters: members of plain structs that a user can set. A struct lists them once, in visit(),
// each with its name, range and description. All code that reads, checks, writes or describes
// parameters uses that list.
//
//   struct KickerParameters {
//     double speed_limit_mps = 8.0;
//     bool chips = true;
//
//     template <typename Self, typename Visitor>
//     static void visit(Self& self, const Visitor& visitor) {
//       visitor(self.speed_limit_mps, {"speed_limit_mps", {0.1, 20}, "top speed of kicks"});
//       visitor(self.chips, {"chips", "whether it can chip"});
//     }
//   };
//
// A visitor is called with a member and its Parameter: [](auto& value, const Parameter& about).
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace autoref {

// The values that a number can have.
struct Range {
  double low = 0;
  double high = 0;
  bool above_low = false;  // `low` itself is not allowed

  // Whether the range contains the value; false for NaN.
  constexpr bool contains(double value) const {
    return (above_low ? value > low : value >= low) && value <= high;
  }
};

// Greater than 0 and at most `high`.
constexpr Range positive(double high) { return {0, high, true}; }

constexpr Range up_to(double high) { return {0, high}; }
constexpr Range from_to(double low, double high) { return {low, high}; }

inline constexpr Range kFraction = {0, 1};
inline constexpr Range kYesOrNo = {0, 1};

// The range as text: "from 0 to 1 m", "above 0 and at most 2".
std::string text_of(const Range& range, std::string_view unit = "");

// The description of a parameter, without its value.
struct Parameter {
  constexpr Parameter(std::string_view its_name, const Range& its_range, std::string_view meaning,
                      std::string_view its_source = "")
      : name(its_name), range(its_range), about(meaning), source(its_source) {}
  // For a bool, an enumeration, or a member with parameters of its own.
  constexpr Parameter(std::string_view its_name, std::string_view meaning)
      : name(its_name), about(meaning) {}

  std::string_view name;    // in snake_case, ending in the unit
  Range range;              // allowed range, for numbers
  std::string_view about;   // what the parameter does or is
  std::string_view source;  // where the default was published; empty if a comment gives the source
};

// The unit at the end of a name: "m/s" for "shot_mps"; empty if the name has no unit.
std::string_view unit_of(std::string_view name);

// The name without its unit: "shot" for "shot_mps".
std::string_view without_unit(std::string_view name);

// A visitor that accepts every parameter and does nothing.
struct AnyParameter {
  template <typename Value>
  void operator()(Value& /*value*/, const Parameter& /*about*/) const {}
};

// Whether a type has parameters of its own.
template <typename Of>
concept HasParameters = requires(Of& of) {
  std::remove_const_t<Of>::visit(of, AnyParameter{});
};

// Visits the parameters of `of`; a member with its own parameters is replaced by these. The
// visitor's third argument is the path: `prefix` followed by names, such as "ball.roll_mps2".
template <HasParameters Of, typename Visitor>
void visit_all(Of& of, const std::string& prefix, const Visitor& visitor) {
  std::remove_const_t<Of>::visit(of, [&](auto& value, const Parameter& about) {
    const std::string path = prefix + std::string(about.name);
    if constexpr (HasParameters<std::remove_reference_t<decltype(value)>>) {
      visit_all(value, path + ".", visitor);
    } else {
      visitor(value, about, path);
    }
  });
}

// The names of the parameters, in order.
template <HasParameters Of>
std::vector<std::string> parameter_names() {
  std::vector<std::string> names;
  const Of of;
  Of::visit(of, [&names](const auto& /*value*/, const Parameter& about) {
    names.emplace_back(about.name);
  });
  return names;
}

// A number outside its allowed range.
class OutOfRange : public std::invalid_argument {
 public:
  // what() is `path` followed by `text`, for example "ball.hop_later_z" and " is 2; it must be from
  // 0 to 0.95".
  OutOfRange(const std::string& path, const std::string& text)
      : std::invalid_argument(path + text), path_(path), text_(text) {}

  const std::string& path() const { return path_; }
  const std::string& text() const { return text_; }

 private:
  std::string path_;
  std::string text_;
};

// Throws OutOfRange: the value of the parameter at `path` is not `allowed`, for example "from 0 to
// 1".
[[noreturn]] void refuse_value(const std::string& path, double value, const std::string& allowed);

// Throws OutOfRange for a value outside the range.
void check_number(const std::string& path, double value, const Range& range);

// Calls check_number() for all numbers of `of`.
template <HasParameters Of>
void check_ranges(const Of& of, const std::string& prefix = "") {
  visit_all(of, prefix, [](const auto& value, const Parameter& about, const std::string& path) {
    using Value = std::remove_cvref_t<decltype(value)>;
    if constexpr (std::is_arithmetic_v<Value> && !std::is_same_v<Value, bool>) {
      check_number(path, static_cast<double>(value), about.range);
    }
  });
}

}  // namespace autoref
