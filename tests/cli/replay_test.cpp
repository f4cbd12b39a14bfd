// `onggi replay --validate`: 0 the same, 1 something differs, 2 damaged.
#include <zlib.h>

#include <cstring>

#include "tests/cli/cli_expectations.h"

namespace onggi::test {
namespace {

constexpr std::size_t kHeaderBytes = 72;

std::uint32_t crc(const char* bytes, std::size_t count) {
    return static_cast<std::uint32_t>(
        ::crc32(0, reinterpret_cast<const Bytef*>(bytes), static_cast<uInt>(count)));
}

// A folder with the session of press-and-hold in it, 1401 ticks.
class Replay : public testing::Test {
  protected:
    void SetUp() override {
        expect_silent_success(run_onggi({"throw", kPressAndHold, "--elements", "100", "--save", "s.onggi"},
                                        {.folder = folder_.path()}));
        bytes_ = content_of(folder_ / "s.onggi");
        std::uint64_t start_state_bytes = 0;
        std::memcpy(&start_state_bytes, bytes_.data() + 40, sizeof start_state_bytes);
        first_block_at_ = kHeaderBytes + start_state_bytes;
    }
    ProgramRun replay(const std::string& bytes) {
        put_file(folder_ / "in.onggi", bytes);
        return run_onggi({"replay", "in.onggi", "--validate"}, {.folder = folder_.path()});
    }

    TemporaryFolder folder_;
    std::string bytes_;
    std::size_t first_block_at_ = 0;
};

TEST_F(Replay, OfAnUntouchedSessionIsTheSame) {
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
    char* block = bytes.data() + first_block_at_;
    block[24] = static_cast<char>(block[24] ^ 1);  // the hash after tick 999
    const std::uint32_t mended = crc(block, 36);
    std::memcpy(block + 36, &mended, sizeof mended);
    expect_one_line(replay(bytes), 1, "the first tick that differs is one of 0 to 999");
}

TEST_F(Replay, NamesTheFirstTickWhoseForceDiffers) {
    std::string bytes = bytes_;
    char* block = bytes.data() + first_block_at_;
    std::uint32_t record_bytes = 0;
    std::uint32_t ticks = 0;
    std::memcpy(&record_bytes, block + 4, 4);
    std::memcpy(&ticks, block + 16, 4);
    block[40 + record_bytes + 4 * 345] ^= 1;  // the check of tick 345
    const std::uint32_t body = crc(block + 40, record_bytes + std::size_t{4} * ticks);
    std::memcpy(block + 20, &body, sizeof body);
    const std::uint32_t head = crc(block, 36);
    std::memcpy(block + 36, &head, sizeof head);
    expect_one_line(replay(bytes), 1, "tick 345 is the first that differs");
}

TEST_F(Replay, NamesAStartThatDiffers) {
    std::string bytes = bytes_;
    bytes[48] = static_cast<char>(bytes[48] ^ 1);  // the start state's hash
    const std::uint32_t mended = crc(bytes.data(), 68);
    std::memcpy(bytes.data() + 68, &mended, sizeof mended);
    expect_one_line(replay(bytes), 1, "tick 0 is the first that differs: the start state");
}

TEST_F(Replay, OfADamagedSessionIsRefused) {
    std::string bytes = bytes_;
    bytes[first_block_at_ + 100] ^= 1;
    expect_one_line(replay(bytes), 2, ": expected the checksum");
}

}  // namespace
}  // namespace onggi::test
