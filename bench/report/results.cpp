#include "bench/report/results.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "arcway/datasets/file_io.h"
#include "bench/quantiles.h"
#include "bench/report/json_message.h"
#include "datasets/io/shortened.h"

namespace arcway::internal::report {
namespace {

using nlohmann::json;
using JsonFile = nlohmann::ordered_json;  ///< keeps the order of keys

constexpr std::string_view kSuffixes[] = {"/real_time", "/process_time", "/manual_time"};
const std::set<std::string> kOwnFields = {
    "name",        "run_name",         "run_type", "family_index",   "per_family_instance_index",
    "repetitions", "repetition_index", "threads",  "iterations",     "real_time",
    "cpu_time",    "time_unit",        "label",    "error_occurred", "error_message",
    "batch"};

double unit_seconds(const std::string& unit, std::string_view file) {
  if (unit == "ns") return 1e-9;
  if (unit == "us") return 1e-6;
  if (unit == "ms") return 1e-3;
  if (unit == "s") return 1.0;
  throw FormatError(std::string(file) + ": time_unit: expected ns, us, ms or s, found \"" + shortened(unit) + "\"");
}

const json& field(const json& object, const char* key, std::string_view place) {
  if (!object.is_object() || !object.contains(key))
    throw FormatError(std::string(place) + ": \"" + key + "\" is missing");
  return object[key];
}

std::string text_of(const json& value) { return value.is_string() ? value.get<std::string>() : value.dump(); }

void read_run(const json& run, const std::string& place, Results& results, std::map<std::string, std::size_t>& index,
              std::map<std::string, std::map<std::string, std::vector<double>>>& counters) {
  if (run.value("run_type", "iteration") != "iteration") return;
  const std::string name = plain_name(text_of(field(run, "name", place)));
  const auto [found, added] = index.try_emplace(name, results.measurements.size());
  if (added)
    results.measurements.push_back(
        {.name = name, .wall_seconds = {}, .cpu_seconds = {}, .counters = {}, .label = {}, .error = {}});
  Measurement& m = results.measurements[found->second];
  m.label = run.value("label", m.label);
  if (run.value("error_occurred", false)) {
    m.error = run.value("error_message", "failed");
    return;
  }
  const double unit = unit_seconds(run.value("time_unit", "ns"), place) / run.value("batch", 1.0);
  for (const char* key : {"real_time", "cpu_time"}) {
    const json& value = field(run, key, place);
    if (!value.is_number())
      throw FormatError(place + ": " + key + ": expected a number, found " + shortened(value.dump()));
    (key[0] == 'r' ? m.wall_seconds : m.cpu_seconds).push_back(unit * value.get<double>());
  }
  for (const auto& [key, value] : run.items())
    if (value.is_number() && !kOwnFields.contains(key)) counters[name][key].push_back(value.get<double>());
}

JsonFile parsed(std::string_view text, std::string_view name) {
  JsonFile document;
  try {
    document = JsonFile::parse(text);
  } catch (const json::parse_error& error) {
    throw FormatError(std::string(name) + ": " + message_of(error));
  }
  for (const char* key : {"context", "benchmarks"})
    if (!document.is_object() || !document.contains(key))
      throw FormatError(std::string(name) + ": \"" + key + "\" is missing");
  return document;
}

std::string name_of(const JsonFile& run) { return run.is_object() ? plain_name(run.value("name", "")) : std::string(); }

std::string context_value(const JsonFile& file, const char* key) { return file["context"].value(key, ""); }

void require_same(const JsonFile& before, const JsonFile& after, const char* key, std::string_view name) {
  const std::string ours = context_value(before, key), theirs = context_value(after, key);
  if (ours != theirs)
    throw FormatError(std::string(name) + ": its " + key + " is \"" + ours + "\", that of the run \"" + theirs +
                      "\": results of two are not mixed");
}

/// One benchmark a line.
std::string file_of(const JsonFile& context, const JsonFile& first, const JsonFile& more) {
  std::string lines;
  for (const JsonFile* benchmarks : {&first, &more})
    for (const auto& benchmark : *benchmarks) lines += (lines.empty() ? "\n" : ",\n") + benchmark.dump();
  return "{\n\"context\": " + context.dump(1) + ",\n\"benchmarks\": [" + lines + "\n]\n}\n";
}

}  // namespace

std::string plain_name(std::string name) {
  for (bool stripped = true; stripped;) {
    stripped = false;
    for (const char* policy : {"/repeats:", "/iterations:"})
      if (const auto at = name.rfind(policy); at != std::string::npos) name.erase(at), stripped = true;
    for (const std::string_view suffix : kSuffixes)
      if (name.ends_with(suffix)) name.erase(name.size() - suffix.size()), stripped = true;
  }
  return name;
}

std::string updated_results(std::string_view earlier, std::string_view run, std::string_view name) {
  const JsonFile before = parsed(earlier, name), after = parsed(run, "the run");
  JsonFile context = before["context"];
  require_same(before, after, "processor", name);
  std::set<std::string> anew;
  for (const auto& benchmark : after["benchmarks"]) anew.insert(name_of(benchmark));
  JsonFile kept = JsonFile::array();
  for (const auto& benchmark : before["benchmarks"])
    if (!anew.contains(name_of(benchmark))) kept.push_back(benchmark);
  const std::string commit = context_value(after, "commit"), updates = context.value("updated_at", "");
  if (updates.find(commit) == std::string::npos)
    context["updated_at"] = updates.empty() ? commit : updates + ", " + commit;
  return file_of(context, kept, after["benchmarks"]);
}

std::string repeated_results(std::string_view earlier, std::string_view run, std::string_view name) {
  const JsonFile before = parsed(earlier, name), after = parsed(run, "the run");
  for (const char* key : {"processor", "commit"}) require_same(before, after, key, name);
  return file_of(before["context"], before["benchmarks"], after["benchmarks"]);
}

Results read_results(std::string_view text, std::string_view name) {
  json document;
  try {
    document = json::parse(text);
  } catch (const json::parse_error& error) {
    throw FormatError(std::string(name) + ": " + message_of(error));
  }
  Results results;
  results.name = name;
  for (const auto& [key, value] : field(document, "context", name).items())
    if (!value.is_structured()) results.context.emplace_back(key, text_of(value));
  const json& runs = field(document, "benchmarks", name);
  if (!runs.is_array()) throw FormatError(std::string(name) + ": benchmarks: expected an array");
  std::map<std::string, std::size_t> index;
  std::map<std::string, std::map<std::string, std::vector<double>>> counters;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const std::string place = std::string(name) + ": benchmarks[" + std::to_string(i) + "]";
    try {
      read_run(runs[i], place, results, index, counters);
    } catch (const json::type_error& error) {
      throw FormatError(place + ": " + message_of(error));
    }
  }
  for (Measurement& m : results.measurements)
    for (const auto& [key, values] : counters[m.name]) m.counters[key] = bench::median(values);
  return results;
}

std::string context_value(const Context& context, std::string_view key) {
  const auto found = std::ranges::find(context, key, &Context::value_type::first);
  return found == context.end() ? std::string() : found->second;
}

SeriesPlace place_of(std::string_view name) {
  SeriesPlace place;
  place.series = name;
  const std::size_t first = name.find('/');
  place.stage = name.substr(0, first);
  const std::size_t last = name.rfind('/');
  const std::size_t colon = last == std::string_view::npos ? last : name.find(':', last);
  if (colon != std::string_view::npos) {
    const std::string_view number = name.substr(colon + 1);
    double size = 0.0;
    const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), size);
    if (error == std::errc() && end == number.data() + number.size()) {
      place.key = name.substr(last + 1, colon - last - 1);
      place.series = name.substr(0, last);
      place.size = size;
    }
  }
  if (place.series.size() > place.stage.size()) place.variant = place.series.substr(place.stage.size() + 1);
  return place;
}

std::vector<const Measurement*> of_stage(const Results& results, std::string_view stage) {
  std::vector<const Measurement*> found;
  for (const Measurement& m : results.measurements)
    if (place_of(m.name).stage == stage && m.error.empty() && !m.wall_seconds.empty()) found.push_back(&m);
  return found;
}

std::size_t threads_of(std::string_view name) {
  constexpr std::string_view kKey = "/threads:";
  const std::size_t at = name.find(kKey);
  std::size_t threads = 1;
  if (at != std::string_view::npos) std::from_chars(name.data() + at + kKey.size(), name.data() + name.size(), threads);
  return threads;
}

}  // namespace arcway::internal::report
