#include "engine/render/upload_ledger.h"

#include <gtest/gtest.h>

#include <memory>

namespace onggi::render {
namespace {

UploadLedger::Upload at(int x, int y, int side = 10) {
    auto painting = std::make_shared<ui::Painting>();
    painting->width = painting->height = side;
    return {x, y, painting};
}

TEST(UploadLedger, KeepsWantingWhatAFrameThatWasNotDrawnDidNotTake) {
    UploadLedger ledger;
    ledger.bring(std::vector{at(0, 0)});
    ledger.bring(std::vector{at(20, 0)});
    EXPECT_EQ(ledger.wanted().size(), 2U);
    ledger.done();
    EXPECT_TRUE(ledger.wanted().empty());
}

TEST(UploadLedger, WantsEverythingAgainAfterTheTextureIsLost) {
    UploadLedger ledger;
    ledger.bring(std::vector{at(0, 0), at(20, 0)});
    ledger.done();
    ledger.bring(std::vector{at(40, 0)});
    ledger.lost();
    EXPECT_EQ(ledger.wanted().size(), 3U);
    ledger.done();
    ledger.lost();
    EXPECT_EQ(ledger.wanted().size(), 3U);
}

TEST(UploadLedger, ForgetsWhatWasPaintedOver) {
    UploadLedger ledger;
    ledger.bring(std::vector{at(0, 0), at(10, 0), at(0, 10)});
    ledger.done();
    ledger.bring(std::vector{at(5, 0)});  // over the first two
    ledger.done();
    ledger.lost();
    ASSERT_EQ(ledger.wanted().size(), 2U);
    for (const UploadLedger::Upload& upload : ledger.wanted())
        EXPECT_TRUE(upload.x == 5 || upload.y == 10);
}

}  // namespace
}  // namespace onggi::render
