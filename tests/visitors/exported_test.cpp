// What visitors' pots weigh on a phone.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "engine/files/gzip.h"
#include "game/app/kiosk/gallery/kiosk_gallery.h"
#include "game/exporter/export.h"
#include "game/finish/glaze.h"
#include "tests/visitors/kiosk_rig.h"
#include "tests/visitors/people.h"

namespace onggi::visitors {
namespace {

class AVisitorsPot : public ::testing::TestWithParam<int> {};

// The glaze with the most to compress.
TEST_P(AVisitorsPot, IsAtMostAMegabyteAndAThirdOfItOnTheWire) {
    KioskRig rig(1000.0);
    throw_a_pot(static_cast<Kind>(GetParam()), 41, {}, rig);
    const auto model = app::glazed_model(rig.clay(), *finish::find_glaze("buncheong"));
    ASSERT_TRUE(model);
    const auto bytes = exporter::encode_pot(*model, exporter::ExportKind::kGlb);
    ASSERT_TRUE(bytes);
    const auto packed = files::gzip(*bytes);
    ASSERT_TRUE(packed);
    fmt::print("{} kB, packed {} kB\n", bytes->size() / 1000, packed->size() / 1000);
    EXPECT_LE(bytes->size(), 1'000'000U);
    EXPECT_LE(packed->size(), 350'000U);
}

INSTANTIATE_TEST_SUITE_P(OfEveryKind, AVisitorsPot, ::testing::Range(0, kKindCount));

}  // namespace
}  // namespace onggi::visitors
