#include "bench/report/citation.h"

#include <gtest/gtest.h>

#include <regex>
#include <string>
#include <vector>

#include "arcway/datasets/file_io.h"

namespace arcway::internal::report {
namespace {

/// All values of a key in a file of the Citation File Format.
std::vector<std::string> values_of(const std::string& text, const std::string& key) {
  std::vector<std::string> values;
  const std::regex line("(?:^|\n)[ -]*" + key + ": ([^\n]+)");
  for (auto it = std::sregex_iterator(text.begin(), text.end(), line); it != std::sregex_iterator(); ++it)
    values.push_back((*it)[1]);
  return values;
}

TEST(Citation, HasTheFactsOfTheCitationFile) {
  const std::string file = read_file(std::string(ARCWAY_SOURCE_DIR) + "/CITATION.cff");
  const std::string cited = citation({});
  std::size_t facts = 0;
  for (const char* key :
       {"title", "name", "version", "license", "family-names", "given-names", "journal", "volume", "year"})
    for (const std::string& value : values_of(file, key)) {
      EXPECT_NE(cited.find(value), std::string::npos) << key << ": " << value;
      ++facts;
    }
  EXPECT_EQ(facts, 14u) << "the file's keys are not those that this test knows";
}

TEST(Citation, NamesYearAndCommitOfTheResults) {
  const Results results{
      .name = "r.json", .context = {{"commit", "abc"}, {"date", "2026-11-24T09:45:46"}}, .measurements = {}};
  const std::string cited = citation(results);
  EXPECT_NE(cited.find("  year    = {2026},\n  note    = {commit abc}\n}"), std::string::npos) << cited;
  EXPECT_EQ(citation({}).find("note"), std::string::npos);
}

}  // namespace
}  // namespace arcway::internal::report
