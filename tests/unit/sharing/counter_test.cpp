#include "game/sharing/open_counter.h"

#include <gtest/gtest.h>

#include <csignal>
#include <filesystem>

#include "tests/support/temporary_folder.h"

namespace onggi::sharing {
namespace {

TEST(OpenCounter, CountsTheWritersEvents) {
    const test::TemporaryFolder folder;
    auto reader = CounterReader::open(folder / "counter");
    ASSERT_TRUE(reader) << reader.error().message;
    EXPECT_TRUE(reader->take().empty()) << "and does not wait";
    CounterWriter writer(folder / "counter");
    writer.count(ShareEvent::kPageOpened);
    writer.count(ShareEvent::kPageOpened);
    writer.count(ShareEvent::kFilmTaken);
    auto counts = reader->take();
    EXPECT_EQ(counts[ShareEvent::kPageOpened], 2);
    EXPECT_EQ(counts[ShareEvent::kFilmTaken], 1);
    EXPECT_TRUE(reader->take().empty());
}

TEST(OpenCounter, NeverWaitsForAReader) {
    std::signal(SIGPIPE, SIG_IGN);
    const test::TemporaryFolder folder;
    CounterWriter nowhere(folder / "counter");
    nowhere.count(ShareEvent::kPageOpened);
    CounterWriter writer(folder / "counter");
    {
        auto reader = CounterReader::open(folder / "counter");
        ASSERT_TRUE(reader);
        writer.count(ShareEvent::kPageOpened);
    }
    writer.count(ShareEvent::kPageOpened);  // no reader any more
    auto again = CounterReader::open(folder / "counter");
    ASSERT_TRUE(again);
    static_cast<void>(again->take());
    writer.count(ShareEvent::kModelTaken);
    EXPECT_EQ(again->take()[ShareEvent::kModelTaken], 1);
    for (int i = 0; i < 100'000; ++i)  // more than a pipe holds
        writer.count(ShareEvent::kPrintTaken);
    EXPECT_GT(again->take()[ShareEvent::kPrintTaken], 10'000);
}

TEST(OpenCounter, RejectsOtherFiles) {
    const test::TemporaryFolder folder;
    test::put_file(folder / "file", "precious");
    const auto refused = CounterReader::open(folder / "file");
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().message,
              (folder / "file").string() + ": expected a pipe, found something else");
    EXPECT_EQ(test::content_of(folder / "file"), "precious");
    EXPECT_FALSE(CounterReader::open(folder / "none/counter"));
}

}  // namespace
}  // namespace onggi::sharing
