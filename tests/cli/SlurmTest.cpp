#include "tests/cli/Comparison.h"
#include "tests/cli/Program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <thread>
#include <unistd.h>

namespace mrpp::test
{

namespace
{

using ::testing::HasSubstr;

/// Planners that take their time, one of them outside.
void prepare(const Scratch &scratch)
{
    scratch.write("plan.yaml",
                  std::string(R"(campaign: spread
seed: 3
repetitions: 4
limits: {time: 30 s, memory: 500 MB}
problems:
  - small_benchmark: [tree, connector, tunnel]
planners:
  - push_and_swap
  - {name: slow, format: solution, motion: pebble,
     command: "sh -c 'sleep 1.5; exec )") +
                      MRPP_PROGRAM +
                      R"( solve --planner push_and_swap --instance $1 --solution $2' sh {instance} {output}"}
optimizers: [redundancy_removal]
reports: [csv]
keep: {instances: true, solutions: true}
)");
}

void runHere(const Scratch &scratch)
{
    ASSERT_EQ(mrppsim({"run", "plan.yaml", "-o", "whole", "--jobs", "4", "-q"}, scratch).code, 0);
}

TEST(Slurm, writesJobsWithWhatThePlanNeeds)
{
    const Scratch scratch;
    prepare(scratch);
    const Outcome outcome =
        mrppsim({"slurm", "plan.yaml", "-o", "it's big", "--shards", "1", "--jobs", "2", "--partition",
                 "long", "--account", "me", "--line=--qos=high", "--at-once", "9"},
                scratch);
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    // 24 runs, two at once, of 30 s for solving, 30 s for the optimizer and 5 s; and ten minutes.
    EXPECT_THAT(outcome.out, HasSubstr("1 part of at most 23 minutes, 2 cores and 1908 MiB each"));
    const std::string array = scratch.read("it's big/array.sh");
    for (const char *line :
         {"--job-name=spread", "--array=1-1%9", "--cpus-per-task=2", "--time=23", "--mem=1908M", "--requeue",
          "--partition=long", "--account=me", "--qos=high", "--signal=B:TERM@60", "--open-mode=append"})
        EXPECT_THAT(array, HasSubstr(std::string("\n#SBATCH ") + line + "\n"));
    for (const char *script : {"array.sh", "merge.sh", "submit.sh"})
        EXPECT_EQ(Process({"bash", "-n", std::string("it's big/") + script}, scratch).wait().code, 0);
    EXPECT_EQ(mrppsim({"slurm", "plan.yaml", "--shards", "2"}, scratch).code, 2);
    EXPECT_EQ(mrppsim({"slurm", "plan.yaml", "-o", "x", "--shards", "0"}, scratch).code, 2);
}

TEST(Slurm, itsJobsRunByHandToo)
{
    const Scratch scratch;
    prepare(scratch);
    runHere(scratch);
    ASSERT_EQ(mrppsim({"slurm", "plan.yaml", "-o", "it's big", "--shards", "3", "--jobs", "4"}, scratch).code,
              0);
    for (const char *part : {"1", "2", "3"})
    {
        const Outcome job =
            Process({"env", std::string("SLURM_ARRAY_TASK_ID=") + part, "bash", "it's big/array.sh"}, scratch)
                .wait();
        EXPECT_EQ(job.code, 0) << job.out << job.err;
    }
    const Outcome merge = Process({"bash", "it's big/merge.sh"}, scratch).wait();
    EXPECT_EQ(merge.code, 0) << merge.out << merge.err;
    expectSameCampaign(scratch, "whole", "it's big/results");
}

/// Two nodes on this machine.
class Cluster
{
public:
    explicit Cluster(const Scratch &scratch) : scratch_(scratch) {}
    ~Cluster() { (void)script({"stop", folder()}); }
    Cluster(const Cluster &) = delete;
    Cluster &operator=(const Cluster &) = delete;

    [[nodiscard]] static bool isPossible()
    {
        bool all = ::geteuid() == 0;
        for (const char *program :
             {"/usr/sbin/slurmctld", "/usr/sbin/slurmd", "/usr/bin/sbatch", "/usr/sbin/munged"})
            all = all && ::access(program, X_OK) == 0;
        return all;
    }

    [[nodiscard]] bool start() const
    {
        std::filesystem::permissions(scratch_.path(), std::filesystem::perms(0711)); // for munge's own user
        const int port = 20000 + static_cast<int>(::getpid()) % 10000 * 3;
        const Outcome outcome = script({"start", folder(), std::to_string(port)});
        if (outcome.code != 0)
            ADD_FAILURE() << outcome.out << outcome.err;
        return outcome.code == 0;
    }

    /// The node dies, and the cluster takes notice.
    void lose(const std::string &node) const
    {
        EXPECT_EQ(script({"lose", folder(), node}).code, 0);
        EXPECT_EQ(run({"scontrol", "update", "nodename=" + node, "state=down", "reason=dead"}).code, 0);
    }

    [[nodiscard]] Outcome run(std::vector<std::string> words) const
    {
        words.insert(words.begin(), {"env", "SLURM_CONF=" + folder() + "/slurm.conf"});
        return Process(words, scratch_).wait();
    }

private:
    [[nodiscard]] std::string folder() const { return (scratch_.path() / "cluster").string(); }
    [[nodiscard]] Outcome script(std::vector<std::string> words) const
    {
        words.insert(words.begin(), {"bash", std::string(MRPP_SOURCE_DIR) + "/tests/cli/mini-slurm.sh"});
        return Process(words, scratch_).wait();
    }

    const Scratch &scratch_;
};

bool await(const Scratch &scratch, const std::string &file, int seconds)
{
    for (int i = 0; i < seconds * 10; ++i)
    {
        if (scratch.has(file))
            return true;
        std::this_thread::sleep_for(std::chrono::milliseconds(100));
    }
    return false;
}

TEST(Slurm, aCampaignThatLosesANodeEndsWithTheResultsOfALocalOne)
{
    if (!Cluster::isPossible())
        GTEST_SKIP() << "needs root and the packages slurmctld, slurmd, slurm-client, munge";
    const Scratch scratch;
    prepare(scratch);
    runHere(scratch);
    const Cluster cluster(scratch);
    ASSERT_TRUE(cluster.start());
    const Outcome submitted = cluster.run(
        mrppsimWords({"slurm", "plan.yaml", "-o", "big", "--shards", "6", "--time", "5", "--submit"}));
    ASSERT_EQ(submitted.code, 0) << submitted.err;
    EXPECT_THAT(submitted.out, HasSubstr("submitted: parts 1, merge and report "));

    ASSERT_TRUE(await(scratch, "big/parts/4.0/results.sqlite", 30))
        << cluster.run({"squeue"}).out; // on the second
    cluster.lose("n2");
    ASSERT_TRUE(await(scratch, "big/results/results.csv", 100)) << cluster.run({"squeue"}).out;
    expectSameCampaign(scratch, "whole", "big/results");
    std::string logs;
    for (const auto &[name, text] : scratch.tree("big/log"))
        logs += text;
    EXPECT_THAT(logs, HasSubstr("begun again 1 times"));
}

} // namespace
} // namespace mrpp::test
