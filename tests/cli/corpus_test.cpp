#include <boost/test/unit_test.hpp>
#include <vector>

#include "tests/cli/shell.hpp"

namespace {

namespace fs = std::filesystem;

std::vector<fs::path> corpus() {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(RAYAUDIT_DATA "/cases"))
    files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace

BOOST_AUTO_TEST_CASE(every_line_of_the_corpus_carries_its_truth) {
  BOOST_TEST(corpus().size() >= 6);
  for (const fs::path& file : corpus())
    BOOST_TEST(shell::run("rayaudit truth '" + file.string() + "' | diff '" + file.string() +
                          "' -") == shell::printed(""),
               file);
}

BOOST_AUTO_TEST_CASE(every_line_of_the_corpus_says_why) {
  for (const fs::path& file : corpus()) {
    std::ifstream lines(file);
    for (std::string line; std::getline(lines, line);)
      BOOST_TEST((line.find("# ") != line.npos), file.string() + ": " + line);
  }
}
