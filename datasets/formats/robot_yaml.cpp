#include "datasets/formats/robot_yaml.h"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string>

#include "arcway/datasets/file_io.h"
#include "datasets/io/number_text.h"
#include "datasets/io/shortened.h"

namespace arcway::internal {
namespace {

constexpr std::size_t kLargestRobotFile = 1 << 20;  // parameters of a robot have some hundred lines
constexpr int kDeepestRobot = 32;
constexpr std::size_t kMostNodes = 100'000;  // aliases may stand for many more than the text has
constexpr std::string_view kParameters = "ros__parameters";
constexpr std::array<std::string_view, 2> kNav2Keys = {"footprint", "minimum_turning_radius"};

class YamlReader {
 public:
  explicit YamlReader(std::string_view name) : name_(name) {}

  nlohmann::json value_of(const YAML::Node& node, int depth = 0) {
    count(node, depth);
    if (node.IsScalar()) return scalar_of(node);
    if (node.IsSequence()) {
      nlohmann::json array = nlohmann::json::array();
      for (const auto& element : node) array.push_back(value_of(element, depth + 1));
      return array;
    }
    if (!node.IsMap()) return nullptr;
    nlohmann::json object = nlohmann::json::object();
    for (const auto& member : node) {
      const std::string key = member.first.as<std::string>();
      if (object.contains(key)) fail(member.first, "the key \"" + key + "\" comes twice");
      object[key] = value_of(member.second, depth + 1);
    }
    return object;
  }

  // Takes the keys of nav2 from below every "ros__parameters".
  void collect(const YAML::Node& node, bool are_parameters, nlohmann::json& robot, int depth = 0) {
    count(node, depth);
    if (!node.IsMap()) return;
    for (const auto& member : node) {
      const std::string key = member.first.as<std::string>();
      const bool is_wanted = std::ranges::find(kNav2Keys, std::string_view(key)) != kNav2Keys.end();
      has_parameters_ = has_parameters_ || key == kParameters;
      if (!are_parameters || !is_wanted) {
        collect(member.second, are_parameters || key == kParameters, robot, depth + 1);
        continue;
      }
      const nlohmann::json value = value_of(member.second, depth + 1);
      if (robot.contains(key) && robot[key] != value)
        fail(member.second, key + " is " + value.dump() + ", but " + robot[key].dump() + " above; leave one out");
      robot[key] = value;
    }
  }
  [[nodiscard]] bool has_parameters() const { return has_parameters_; }

 private:
  [[noreturn]] void fail(const YAML::Node& node, const std::string& message) const {
    throw FormatError(std::string(name_) + ": line " + std::to_string(node.Mark().line + 1) + ": " + message);
  }
  void count(const YAML::Node& node, int depth) {
    if (depth > kDeepestRobot) fail(node, "nested more than " + std::to_string(kDeepestRobot) + " deep");
    if (++nodes_ > kMostNodes) fail(node, "more than " + std::to_string(kMostNodes) + " values");
  }
  // A number where it is one and has no quotes, else a text.
  static nlohmann::json scalar_of(const YAML::Node& node) {
    const std::string& text = node.Scalar();
    if (node.Tag() == "!") return text;
    if (const std::optional<double> number = read_number(text)) return *number;
    return text;
  }

  std::string_view name_;
  std::size_t nodes_ = 0;
  bool has_parameters_ = false;
};

}  // namespace

nlohmann::json robot_of_yaml(std::string_view yaml, std::string_view name) {
  if (yaml.size() > kLargestRobotFile)
    throw FormatError(std::string(name) + ": " + std::to_string(yaml.size()) +
                      " bytes are too many for a robot's YAML");
  try {
    const YAML::Node document = YAML::Load(std::string(yaml));
    YamlReader reader(name);
    nlohmann::json robot = nlohmann::json::object();
    reader.collect(document, false, robot);
    if (!reader.has_parameters()) return reader.value_of(document);
    if (robot.empty())
      throw FormatError(std::string(name) + ": no \"footprint\" or \"minimum_turning_radius\" below \"" +
                        std::string(kParameters) + "\"");
    return robot;
  } catch (const YAML::Exception& error) {
    throw FormatError(std::string(name) + ": line " + std::to_string(error.mark.line + 1) + ": " +
                      shortened(error.msg, kMostOfParser));
  }
}

}  // namespace arcway::internal
