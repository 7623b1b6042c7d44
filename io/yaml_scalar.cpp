#include "io/yaml_scalar.hpp"

#include <yaml-cpp/yaml.h>

namespace autoref::io {

std::string quoted_scalar(const std::string& text) {
  YAML::Emitter emitter;
  emitter << YAML::DoubleQuoted << text;
  return emitter.c_str();
}

}  // namespace autoref::io
