#pragma once

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>

namespace arcway::internal::test {

/// Whether a value is of a JSON Schema type.
inline bool has_type(const nlohmann::json& value, const std::string& type) {
  if (type == "integer") return value.is_number_integer();
  if (type == "number") return value.is_number();
  return type == (value.is_boolean() ? "boolean" : value.type_name());
}

/// The first rule of a JSON Schema that a value breaks, with its place; empty if it breaks none. Knows the keywords
/// that the schemas of datasets/schemas use.
inline std::string broken_rule(const nlohmann::json& schema, const nlohmann::json& value,
                               const std::string& place = "$") {
  for (const auto& [key, rule] : schema.items()) {
    const auto fail = [&, &word = key] { return place + ": " + word + ": " + value.dump().substr(0, 80); };
    if (key == "type") {
      const nlohmann::json types = rule.is_array() ? rule : nlohmann::json::array({rule});
      if (std::none_of(types.begin(), types.end(), [&](const auto& type) { return has_type(value, type); }))
        return fail();
    } else if (key == "const") {
      if (value != rule) return fail();
    } else if (key == "enum") {
      if (std::find(rule.begin(), rule.end(), value) == rule.end()) return fail();
    } else if (key == "minimum") {
      if (value.is_number() && value < rule) return fail();
    } else if (key == "exclusiveMinimum") {
      if (value.is_number() && value <= rule) return fail();
    } else if (key == "maximum") {
      if (value.is_number() && value > rule) return fail();
    } else if (key == "minItems") {
      if (value.is_array() && value.size() < rule) return fail();
    } else if (key == "maxItems") {
      if (value.is_array() && value.size() > rule) return fail();
    } else if (key == "required") {
      for (const auto& name : rule)
        if (!value.contains(name.get<std::string>())) return place + ": lacks " + name.dump();
    } else if (key == "items") {
      for (std::size_t i = 0; value.is_array() && i < value.size(); ++i)
        if (auto broken = broken_rule(rule, value[i], place + "[" + std::to_string(i) + "]"); !broken.empty())
          return broken;
    } else if (key == "properties") {
      if (!value.is_object()) continue;
      for (const auto& [name, member] : value.items()) {
        if (rule.contains(name)) {
          if (auto broken = broken_rule(rule[name], member, place + "." + name); !broken.empty()) return broken;
        } else if (schema.value("additionalProperties", true) == false) {
          return place + ": has \"" + name + "\"";
        }
      }
    } else if (key == "oneOf") {
      if (std::count_if(rule.begin(), rule.end(), [&](const auto& one) { return broken_rule(one, value).empty(); }) !=
          1)
        return fail();
    } else if (key != "$schema" && key != "title" && key != "description" && key != "additionalProperties") {
      return place + ": the test knows no keyword " + key;
    }
  }
  return "";
}

}  // namespace arcway::internal::test
