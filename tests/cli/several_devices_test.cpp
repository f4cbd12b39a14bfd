// A machine with two Vulkan devices.
#include <string>
#include <vector>

#include "tests/cli/cli_expectations.h"
#include "tests/support/two_drivers.h"

namespace onggi::test {
namespace {

class SeveralDevices : public testing::Test {
  protected:
    void SetUp() override {
        const std::string& both = drivers_.manifests();
        ASSERT_FALSE(both.empty());
        environment_ = {"VK_ICD_FILENAMES=" + both, "VK_DRIVER_FILES=" + both,
                        // The driver leaks, and is unloaded before LeakSanitizer could find its name.
                        "ASAN_OPTIONS=detect_leaks=0"};
    }

    [[nodiscard]] ProgramOptions with_request(const std::string& request) const {
        ProgramOptions options{.folder = folder_.path(), .environment = environment_};
        options.environment.push_back("ONGGI_VULKAN_DEVICE=" + request);
        return options;
    }
    [[nodiscard]] ProgramRun draw(const std::string& request, const std::string& name) const {
        return run_onggi({"throw", kPressAndHold, "--screenshot", name, "--size", "80x48"},
                         with_request(request));
    }
    [[nodiscard]] std::string doctor_of(const std::string& request, const std::string& line) const {
        const ProgramRun run = run_onggi({"doctor"}, with_request(request));
        EXPECT_EQ(run.exit_code, 0) << run.err;
        const std::size_t at = run.out.find(line);
        if (at == std::string::npos) return {};
        const std::size_t first = run.out.rfind('\n', at) + 1;
        return run.out.substr(first, run.out.find('\n', at) - first);
    }

    TwoDrivers drivers_;
    TemporaryFolder folder_;
    std::vector<std::string> environment_;
};

TEST_F(SeveralDevices, AreNamedAndOneOfThemIsChosen) {
    for (const int requested : {0, 1}) {
        for (const int device : {0, 1}) {
            const std::string line =
                doctor_of(std::to_string(requested), "device " + std::to_string(device) + ": ");
            EXPECT_NE(line.find("llvmpipe"), std::string::npos) << line;
            EXPECT_EQ(line.ends_with(", chosen"), device == requested) << line;
            EXPECT_EQ(line.starts_with("good"), device == requested) << line;
        }
    }
    EXPECT_TRUE(doctor_of("", "device 0: ").ends_with(", chosen")) << "of two that are alike the first";
}

TEST_F(SeveralDevices, AnUnknownRequestIsRefusedInOneLineThatListsThem) {
    const ProgramRun run = draw("2", "p.png");
    expect_one_line(run, 2, "ONGGI_VULKAN_DEVICE '2'");
    EXPECT_NE(run.err.find("0 llvmpipe"), std::string::npos) << run.err;
    EXPECT_NE(run.err.find("1 llvmpipe"), std::string::npos) << run.err;
    EXPECT_TRUE(folder_.names().empty());
    EXPECT_TRUE(doctor_of("2", "ONGGI_VULKAN_DEVICE '2'").starts_with("lacking"));
}

TEST_F(SeveralDevices, DoctorReportsTheBackendOfEachChoice) {
    ProgramOptions options = with_request("");
    const auto picture_line = [&](const std::string& backend) {
        const ProgramRun run = run_onggi({"doctor", "--backend", backend}, options);
        EXPECT_EQ(run.exit_code, 0) << run.err;
        const std::size_t at = run.out.find("backend " + backend);
        return at == std::string::npos ? run.out : run.out.substr(at, run.out.find('\n', at) - at);
    };
    EXPECT_NE(picture_line("auto").find("drawn by the processor"), std::string::npos) << picture_line("auto");
    EXPECT_NE(picture_line("cpu").find("drawn by the processor"), std::string::npos) << picture_line("cpu");
    EXPECT_NE(picture_line("gpu").find("drawn by the device, which is software"), std::string::npos);
    put_file(folder_ / "settings.toml", "[screen]\nbackend = \"gpu\"\n");
    const ProgramRun by_settings =
        run_onggi({"doctor", "--config", (folder_ / "settings.toml").string()}, options);
    EXPECT_NE(by_settings.out.find("backend gpu: "), std::string::npos) << by_settings.out;
    expect_one_line(run_onggi({"doctor", "--backend", "vulkan"}, options), 2,
                    "--backend: expected gpu|cpu|auto, found 'vulkan'");
}

TEST_F(SeveralDevices, DrawTheSamePicture) {
#if defined(__SANITIZE_THREAD__)
    GTEST_SKIP() << "the software Vulkan driver has races of its own, which ThreadSanitizer reports";
#endif
    expect_silent_success(draw("0", "first.png"));
    expect_silent_success(draw("1", "second.png"));
    const std::string first = content_of(folder_ / "first.png");
    ASSERT_TRUE(first.starts_with("\x89PNG")) << first.size();
    EXPECT_TRUE(first == content_of(folder_ / "second.png"));
}

}  // namespace
}  // namespace onggi::test
