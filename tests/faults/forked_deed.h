// Runs an action of the kiosk in a fork of the test, on a fresh copy of a museum's folder.
#pragma once

#include <gtest/gtest.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <filesystem>
#include <functional>

#include "tests/faults/museum.h"
#include "tests/support/temporary_folder.h"

namespace onggi::faults {

// The child's report before its end, in shared memory.
struct Told {
    long calls = 0;
    bool is_done = false;
    std::array<char, 512> failed_call{};
};

struct Ended {
    Told told;
    int status = 0;  // as waitpid() has it
};

class ForkedDeed : public testing::Test {
  protected:
    static void SetUpTestSuite() {
        base_ = new test::TemporaryFolder;
        lay_out(base_->path() / "museum");
        void* const memory =
            ::mmap(nullptr, sizeof(Told), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
        ASSERT_NE(memory, MAP_FAILED);
        told_ = new (memory) Told;
    }
    static void TearDownTestSuite() {
        ::munmap(told_, sizeof(Told));
        delete base_;
    }
    // The same museum again and again.
    std::filesystem::path fresh() {
        std::filesystem::remove_all(folder_ / "museum");
        std::filesystem::copy(laid_out(), folder_ / "museum", std::filesystem::copy_options::recursive);
        return folder_ / "museum";
    }
    static std::filesystem::path laid_out() { return base_->path() / "museum"; }
    static Ended in_a_fork(const std::function<void(Told&)>& act) {
        *told_ = {};
        const pid_t child = ::fork();
        if (child == 0) {
            act(*told_);
            ::_exit(0);
        }
        Ended ended;
        ::waitpid(child, &ended.status, 0);
        ended.told = *told_;
        return ended;
    }

    test::TemporaryFolder folder_;

  private:
    static inline test::TemporaryFolder* base_ = nullptr;
    static inline Told* told_ = nullptr;
};

}  // namespace onggi::faults
