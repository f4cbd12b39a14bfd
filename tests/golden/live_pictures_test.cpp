// The picture on a machine without a GPU: the CPU backend with smoothed silhouettes, at the quality step for
// one core, against the approved picture.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "engine/render/quality.h"
#include "engine/vk/offscreen.h"
#include "tests/golden/alike.h"
#include "tests/golden/live_scenes.h"
#include "tests/support/image_gate.h"
#include "tests/support/validated_device.h"

namespace onggi::golden {
namespace {

class LivePictures : public support::ValidatedDevice, public testing::WithParamInterface<LiveScene> {};

TEST_P(LivePictures, EqualTheOnesThatWereLookedAt) {
    const GoldenScene shown = scene_named(GetParam().pot);
    const support::RenderInfo info{.driver = device_->description().driver,
                                   .version = device_->description().driver_info,
                                   .driver_info = device_->description().driver_info,
                                   .state_hash = fmt::format("{:016x}", shown.hash())};
    const auto desc =
        render::quality_desc(render::QualityStep::kOneCore, vk::Offscreen::kFormat, shown.height);
    EXPECT_TRUE(support::matches_golden(GetParam().name, draw_live(*device_, GetParam(), desc), info));
}

// A wet lump, hands at work, a bowl, a steep wall, a view into a pot, a collapsed one, one that is cut and
// shows its load, a glazed one, and evening.
INSTANTIATE_TEST_SUITE_P(OfThePot, LivePictures,
                         testing::Values(LiveScene{"live-centring", "centring"},
                                         LiveScene{"live-pulling", "pulling"}, LiveScene{"live-bowl", "wide"},
                                         LiveScene{"live-vase", "vase"}, LiveScene{"live-inside", "inside"},
                                         LiveScene{"live-failure", "failure"}, LiveScene{"live-load", "load"},
                                         LiveScene{"live-celadon", "celadon"},
                                         LiveScene{"live-evening", "stoneware-wet", 1.0}),
                         [](const auto& tested) { return test_name({.name = tested.param.name}); });

}  // namespace
}  // namespace onggi::golden
