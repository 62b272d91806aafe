#include "arcway/plan_result.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <string>

namespace arcway::internal {
namespace {

std::string text_of(const std::string& file) {
  std::ifstream in(std::string(ARCWAY_SOURCE_DIR) + "/" + file);
  return {std::istreambuf_iterator<char>(in), {}};
}

// Everything that the expression finds, by its first group.
std::set<std::string> found(const std::string& text, const std::string& expression) {
  const std::regex pattern(expression);
  std::set<std::string> names;
  for (std::sregex_iterator match(text.begin(), text.end(), pattern); match != std::sregex_iterator(); ++match)
    names.insert((*match)[1]);
  return names;
}

TEST(PlanStatus, IsExplainedInTheReadme) {
  const std::string readme = text_of("core/README.md");
  for (int i = 0; i <= static_cast<int>(PlanStatus::kCanceled); ++i) {
    const std::string name = name_of(static_cast<PlanStatus>(i));
    EXPECT_NE(name, "unknown");
    EXPECT_NE(readme.find("` | " + name + " | "), std::string::npos) << name;
  }
  EXPECT_STREQ(name_of(static_cast<PlanStatus>(static_cast<int>(PlanStatus::kCanceled) + 1)), "unknown");
  const std::string header = text_of("core/include/arcway/plan_result.h");
  const std::size_t begin = header.find("enum class PlanStatus");
  const std::string statuses = header.substr(begin, header.find("};", begin) - begin);
  EXPECT_EQ(found(statuses, "\\n  (k[A-Z]\\w+)"), found(readme, "\\n\\| `(k[A-Z]\\w+)` \\|"));
}

TEST(Exceptions, OfPublicHeadersAreExplainedInTheReadme) {
  const std::set<std::string> explained =
      found(text_of("core/README.md"), "\\n\\| `([\\w:]*(?:[eE]rror|Canceled|std::\\w+))` \\|");
  EXPECT_EQ(explained.count("WorldError"), 1u);
  for (const char* const header :
       {"core/include/arcway/executor.h", "core/include/arcway/planner.h", "core/include/arcway/snapshot.h",
        "core/include/arcway/trajectory.h", "core/include/arcway/world.h",
        "accel/include/arcway/accel/visibility_map.h", "datasets/include/arcway/datasets/file_io.h",
        "datasets/include/arcway/datasets/random_queries.h"}) {
    const std::string text = text_of(header);
    std::set<std::string> thrown = found(text, "@throws ([\\w:]+)");
    thrown.merge(found(text, "; (std::\\w+(?:error|argument|range)) (?:if|unless|for)"));
    thrown.merge(found(text, "class ARCWAY_API (\\w+) : public std::"));
    EXPECT_FALSE(thrown.empty()) << header;
    for (const std::string& name : thrown) EXPECT_EQ(explained.count(name), 1u) << name << " of " << header;
  }
}

}  // namespace
}  // namespace arcway::internal
