// The tool over several processes of this machine, against the tool alone.

#ifdef ARCWAY_MPI_TOOL

#include <gtest/gtest.h>

#include <string>

#include "tests/support/tool.h"

namespace {

namespace fs = std::filesystem;
using arcway::internal::test::Tool;
using arcway::internal::test::without_times;

class MpiTool : public Tool {
 protected:
  static std::string mpirun(int processes) {
    return "\"" ARCWAY_MPIRUN "\" --allow-run-as-root --oversubscribe -np " + std::to_string(processes) + " ";
  }
  Run run_on(int processes, const std::string& arguments) const {
    return run_command(mpirun(processes) + "\"" ARCWAY_MPI_TOOL "\" " + arguments + " --threads 1");
  }
};

TEST_F(MpiTool, WritesTheSamePreparedMapAsOneProcess) {
  const std::string prepare = "prepare clutter/star/n60/m6/f20/s3 --out ";
  ASSERT_EQ(run(prepare + file("expected")).code, 0);
  for (const int processes : {1, 2, 3}) {
    const Run result = run_on(processes, prepare + file("m"));
    ASSERT_EQ(result.code, 0) << result.err;
    EXPECT_EQ(read("m"), read("expected")) << processes;
    fs::remove(file("m"));
  }
}

TEST_F(MpiTool, AnswersABatchAsOneProcess) {
  ASSERT_EQ(run("generate clutter/star/n30/m6/f20/s3 --out " + file("w.geojson") + " --queries " + file("q.csv")).code,
            0);
  const std::string plan = "plan " + file("w.geojson") + " --queries " + file("q.csv") + " --out ";
  ASSERT_EQ(run(plan + file("expected.csv")).code, 0);
  const std::string expected = without_times(read("expected.csv"));
  ASSERT_NE(expected.find("solved"), std::string::npos);
  for (const int processes : {2, 3}) {
    const Run result = run_on(processes, plan + file("r.csv"));
    ASSERT_EQ(result.code, 0) << result.err;
    EXPECT_EQ(without_times(read("r.csv")), expected) << processes;
    fs::remove(file("r.csv"));
  }
}

TEST_F(MpiTool, ALostProcessEndsTheRunWithAnErrorAndNoFile) {
  for (const char* lost : {"0", "1"}) {
    // That process is killed when it has been working for a while.
    const std::string one =
        "if [ \"$OMPI_COMM_WORLD_RANK\" = " + std::string(lost) + " ]; then exec timeout -s KILL 0.7 ";
    const std::string tool =
        "\"" ARCWAY_MPI_TOOL "\" prepare clutter/star/n20000/m10/s1 --threads 1 --out " + file("m");
    const Run result = run_command(mpirun(3) + "sh -c '" + one + tool + "; else exec " + tool + "; fi'");
    EXPECT_NE(result.code, 0);
    EXPECT_EQ(result.out, "");
    EXPECT_NE(result.err.find("signal 9"), std::string::npos) << result.err;
    for (const auto& entry : fs::directory_iterator(folder_))
      EXPECT_NE(entry.path().filename().string().rfind("m", 0), 0u) << entry.path();
  }
}

TEST_F(MpiTool, AnErrorEndsAllProcesses) {
  const Run result = run_on(2, "prepare " + put("bad.geojson", "{") + " --out " + file("m"));
  EXPECT_EQ(result.code, 2) << result.err;
  EXPECT_FALSE(exists("m"));
}

}  // namespace

#endif
