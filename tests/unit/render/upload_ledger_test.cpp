#include "engine/render/upload_ledger.h"

#include <gtest/gtest.h>

#include <memory>

namespace onggi::render {
namespace {

constexpr int kSidePx = 64;

UploadLedger::Upload at(int x, int y, int side = 10) {
    auto painting = std::make_shared<ui::Painting>();
    painting->width = painting->height = side;
    return {x, y, painting};
}

TEST(UploadLedger, KeepsUploadsOfASkippedFramePending) {
    UploadLedger ledger;
    ledger.bring(std::vector{at(0, 0)}, kSidePx);
    ledger.bring(std::vector{at(20, 0)}, kSidePx);
    EXPECT_EQ(ledger.wanted().size(), 2U);
    ledger.done();
    EXPECT_TRUE(ledger.wanted().empty());
}

TEST(UploadLedger, WantsEverythingAgainAfterTheTextureIsLost) {
    UploadLedger ledger;
    ledger.bring(std::vector{at(0, 0), at(20, 0)}, kSidePx);
    ledger.done();
    ledger.bring(std::vector{at(40, 0)}, kSidePx);
    ledger.lost();
    EXPECT_EQ(ledger.wanted().size(), 3U);
    ledger.done();
    ledger.lost();
    EXPECT_EQ(ledger.wanted().size(), 3U);
}

TEST(UploadLedger, ForgetsATextureOfAnotherSize) {
    UploadLedger ledger;
    ledger.bring(std::vector{at(0, 0), at(50, 50)}, kSidePx);
    ledger.done();
    ledger.bring(std::vector{at(10, 10)}, kSidePx / 2);
    EXPECT_EQ(ledger.wanted().size(), 1U);
    ledger.lost();
    EXPECT_EQ(ledger.wanted().size(), 1U);
}

TEST(UploadLedger, DropsOverwrittenUploads) {
    UploadLedger ledger;
    ledger.bring(std::vector{at(0, 0), at(10, 0), at(0, 10)}, kSidePx);
    ledger.done();
    ledger.bring(std::vector{at(5, 0)}, kSidePx);  // over the first two
    ledger.done();
    ledger.lost();
    ASSERT_EQ(ledger.wanted().size(), 2U);
    for (const UploadLedger::Upload& upload : ledger.wanted())
        EXPECT_TRUE(upload.x == 5 || upload.y == 10);
}

}  // namespace
}  // namespace onggi::render
