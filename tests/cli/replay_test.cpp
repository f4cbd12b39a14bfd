// `onggi replay --validate`: 0 the same, 1 something differs, 2 damaged.
#include "tests/cli/cli_expectations.h"
#include "tests/support/session_checksums.h"

namespace onggi::test {
namespace {

// A folder with the session of press-and-hold in it, 1401 ticks.
class Replay : public testing::Test {
  protected:
    void SetUp() override {
        expect_silent_success(
            run_onggi({"throw", kPressAndHold, "--clay", "paper", "--elements", "100", "--save", "s.onggi"},
                      {.folder = folder_.path()}));
        bytes_ = content_of(folder_ / "s.onggi");
        first_block_at_ = kSessionHeaderBytes + get_at<std::uint64_t>(bytes_, 40);
    }
    ProgramRun replay(const std::string& bytes) {
        put_file(folder_ / "in.onggi", bytes);
        return run_onggi({"replay", "in.onggi", "--validate"}, {.folder = folder_.path()});
    }

    TemporaryFolder folder_;
    std::string bytes_;
    std::size_t first_block_at_ = 0;
};

TEST_F(Replay, OfAnUnchangedSessionIsTheSame) {
    const ProgramRun run = replay(bytes_);
    EXPECT_EQ(run.exit_code, 0);
    EXPECT_EQ(run.err, "");
    EXPECT_NE(run.out.find("in.onggi: 1401 ticks replayed"), std::string::npos) << run.out;
}

TEST_F(Replay, OfACutSessionIsTheSameAndSaysSo) {
    for (const std::size_t cut : {1U, 41U, 5000U}) {
        const ProgramRun run = replay(bytes_.substr(0, bytes_.size() - cut));
        EXPECT_EQ(run.exit_code, 0);
        EXPECT_NE(run.err.find("cut short"), std::string::npos) << run.err;
    }
}

TEST_F(Replay, NamesTheIntervalInWhichAStateDiffers) {
    std::string bytes = bytes_;
    bytes[first_block_at_ + 24] ^= 1;  // the hash after tick 999
    mend_session(bytes);
    expect_one_line(replay(bytes), 1, "the first tick that differs is one of 0 to 999");
}

TEST_F(Replay, NamesTheFirstTickWhoseForceDiffers) {
    std::string bytes = bytes_;
    const std::size_t records_at = first_block_at_ + kSessionBlockHeadBytes;
    const auto record_bytes = get_at<std::uint32_t>(bytes, first_block_at_ + 4);
    bytes[records_at + record_bytes + std::size_t{4} * 345] ^= 1;  // the check of tick 345
    mend_session(bytes);
    expect_one_line(replay(bytes), 1, "tick 345 is the first that differs");
}

TEST_F(Replay, NamesAStartThatDiffers) {
    std::string bytes = bytes_;
    bytes[48] ^= 1;  // the start state's hash
    mend_session(bytes);
    expect_one_line(replay(bytes), 1, "tick 0 is the first that differs: the start state");
}

TEST_F(Replay, OfADamagedSessionIsRefused) {
    std::string bytes = bytes_;
    bytes[first_block_at_ + 100] ^= 1;
    expect_one_line(replay(bytes), 2, ": expected the checksum");
}

}  // namespace
}  // namespace onggi::test
