#include "engine/jobs/thread_setup.h"

#include <gtest/gtest.h>
#include <sched.h>

#include <atomic>
#include <cerrno>
#include <cstdlib>
#include <thread>
#include <vector>

namespace onggi::jobs {
namespace {

std::vector<int> cores_of_this_thread() {
    cpu_set_t mask;
    CPU_ZERO(&mask);
    EXPECT_EQ(sched_getaffinity(0, sizeof mask, &mask), 0);
    std::vector<int> cores;
    for (int core = 0; core < CPU_SETSIZE; ++core) {
        if (CPU_ISSET(static_cast<std::size_t>(core), &mask)) cores.push_back(core);
    }
    return cores;
}

TEST(HapticCore, IsTheLastOneTheProcessMayUse) {
    const CoreChoice choice = choose_haptic_core(std::vector<int>{1, 2, 5});
    EXPECT_EQ(choice.core, 5);
    EXPECT_EQ(choice.others, (std::vector<int>{1, 2}));
    EXPECT_FALSE(choice.shared());
}

TEST(HapticCore, IsSharedWhenThereIsOnlyOne) {
    const CoreChoice choice = choose_haptic_core(std::vector<int>{3});
    EXPECT_EQ(choice.core, 3);
    EXPECT_TRUE(choice.shared());
}

TEST(HapticCore, IsUnknownWithoutCoreInformation) {
    const CoreChoice choice = choose_haptic_core(std::vector<int>{});
    EXPECT_EQ(choice.core, -1);
    EXPECT_TRUE(choice.shared());
}

TEST(ThreadSetup, PinsTheThreadToTheHapticCoreAndKeepsAnotherOffIt) {
    // On threads of their own, so that the test program's mask stays as it was.
    const CoreChoice choice = choose_haptic_core();
    ASSERT_GE(choice.core, 0);
    std::thread([&] {
        const RealTimeReport report =
            set_up_this_thread({.core = choice, .fifo_priority = 0, .lock_memory = false});
        EXPECT_EQ(report.pinning.grant, Grant::kGranted);
        EXPECT_EQ(report.memory_lock.grant, Grant::kNotAsked);
        EXPECT_EQ(cores_of_this_thread(), std::vector<int>{choice.core});
    }).join();
    std::thread([&] {
        const Granted kept_off = keep_this_thread_off_haptic_core(choice);
        if (choice.shared()) {
            EXPECT_EQ(kept_off.grant, Grant::kNotAsked);
        } else {
            EXPECT_EQ(kept_off.grant, Grant::kGranted);
            EXPECT_EQ(cores_of_this_thread(), choice.others);
            // Threads started later inherit the mask, so this must come first.
            std::thread([&] { EXPECT_EQ(cores_of_this_thread(), choice.others); }).join();
        }
    }).join();
}

TEST(ThreadSetup, TellsSoftwareVulkanToStayOffTheCoreUnlessTheUserHasSaidOtherwise) {
    const std::vector<int> all = cores_of_this_thread();
    const CoreChoice choice{.core = all.back() + 1, .others = {all.front()}};
    unsetenv("LP_NUM_THREADS");
    std::thread([&] { EXPECT_EQ(keep_this_thread_off_haptic_core(choice).grant, Grant::kGranted); }).join();
    EXPECT_STREQ(std::getenv("LP_NUM_THREADS"), "0");
    setenv("LP_NUM_THREADS", "3", 1);
    std::thread([&] { EXPECT_EQ(keep_this_thread_off_haptic_core(choice).grant, Grant::kGranted); }).join();
    EXPECT_STREQ(std::getenv("LP_NUM_THREADS"), "3");
}

TEST(ThreadSetup, KeepsAThreadOffTheCoreThatHasTakenAllCoresForItself) {
    const std::vector<int> all = cores_of_this_thread();
    const CoreChoice choice = choose_haptic_core(all);
    if (choice.shared()) {
        EXPECT_EQ(keep_all_threads_off_haptic_core(choice).grant, Grant::kNotAsked);
        return;
    }
    std::atomic<bool> is_kept_off{false};
    std::vector<int> found;
    std::thread other([&] {
        while (!is_kept_off)
            std::this_thread::yield();
        found = cores_of_this_thread();
    });
    EXPECT_EQ(keep_all_threads_off_haptic_core(choice).grant, Grant::kGranted);
    EXPECT_EQ(cores_of_this_thread(), choice.others);
    is_kept_off = true;
    other.join();
    EXPECT_EQ(found, choice.others);
    // Restored for later tests.
    EXPECT_EQ(keep_all_threads_off_haptic_core({.core = all.back() + 1, .others = all}).grant,
              Grant::kGranted);
}

TEST(ThreadSetup, RecordsEachRefusalOfTheKernelWithItsReason) {
    const CoreChoice no_such_core{.core = CPU_SETSIZE - 1, .others = {0}};
    std::thread([&] {
        const RealTimeReport report =
            set_up_this_thread({.core = no_such_core, .fifo_priority = 0, .lock_memory = false});
        EXPECT_EQ(report.pinning.grant, Grant::kRefused);
        EXPECT_EQ(report.pinning.error, EINVAL);
        EXPECT_EQ(report.fifo.grant, Grant::kRefused);
        EXPECT_NE(report.fifo.error, 0);
        EXPECT_FALSE(report.nothing_refused());
        const std::vector<RealTimeLack> lacks = report.lacks();
        ASSERT_EQ(lacks.size(), 2U);
        for (const RealTimeLack& lack : lacks) {
            for (const std::string* line : {&lack.what, &lack.cost, &lack.remedy}) {
                EXPECT_FALSE(line->empty());
                EXPECT_EQ(line->find('\n'), std::string::npos);
            }
        }
    }).join();
}

TEST(RealTimeReport, NamesASharedCoreAsALackButNotAsARefusal) {
    RealTimeReport report;
    report.core = choose_haptic_core(std::vector<int>{0});
    report.fifo.grant = report.pinning.grant = report.memory_lock.grant = Grant::kGranted;
    EXPECT_TRUE(report.nothing_refused());
    ASSERT_EQ(report.lacks().size(), 1U);
    EXPECT_NE(report.lacks().front().what.find("one core"), std::string::npos);
    EXPECT_STREQ(report.scheduler(), "fifo");
}

TEST(RealTimeReport, NamesDrowsyCoresAsALackButRunsWithThem) {
    RealTimeReport report;
    report.core = choose_haptic_core(std::vector<int>{0, 1});
    report.fifo.grant = report.pinning.grant = report.memory_lock.grant = Grant::kGranted;
    report.wakeful_cores = {Grant::kRefused, EACCES};
    EXPECT_TRUE(report.nothing_refused());
    ASSERT_EQ(report.lacks().size(), 1U);
    EXPECT_NE(report.lacks().front().remedy.find("/dev/cpu_dma_latency"), std::string::npos);
}

TEST(WakefulCores, CanBeAskedForReleasedAndAskedForAgain) {
    WakefulCores cores;
    const Granted first = cores.request();
    EXPECT_NE(first.grant, Grant::kNotAsked);
    EXPECT_EQ(first.grant == Grant::kRefused, first.error != 0);
    cores.release();
    cores.release();
    EXPECT_EQ(cores.request().grant, first.grant);
}

TEST(RealTimeReport, ReportsNoLackWhenAllIsGranted) {
    RealTimeReport report;
    report.core = choose_haptic_core(std::vector<int>{0, 1});
    report.fifo.grant = report.pinning.grant = report.memory_lock.grant = Grant::kGranted;
    EXPECT_TRUE(report.lacks().empty());
}

TEST(RealTimeProbe, LeavesTheAskingThreadAsItWas) {
    const std::vector<int> before = cores_of_this_thread();
    const RealTimeReport report = probe_real_time({.core = choose_haptic_core()});
    EXPECT_NE(report.fifo.grant, Grant::kNotAsked);
    EXPECT_NE(report.memory_lock.grant, Grant::kNotAsked);
    EXPECT_NE(report.wakeful_cores.grant, Grant::kNotAsked);
    EXPECT_EQ(cores_of_this_thread(), before);
    EXPECT_EQ(sched_getscheduler(0), SCHED_OTHER);
}

}  // namespace
}  // namespace onggi::jobs
