// One device for each driver, as the bus describes it. For tests.
#pragma once

#include "tests/device/mock_hid.h"
#include "tests/support/hex.h"
#include "tests/support/pid_descriptors.h"

namespace onggi::testing {

inline const MockHid kSpaceMouse{
    .node = 5,
    .vendor_id = 0x256f,
    .product_id = 0xc635,
    .maker = "3Dconnexion",
    .product = "SpaceMouse Compact",
    .descriptor = testing::hex("05 01 09 08 a1 01 | 85 01 09 30 09 31 09 32 16 a2 fe 26 5e 01 "
                               "75 10 95 03 81 02 | 85 02 09 33 09 34 09 35 81 02 | c0")};
inline const MockHid kPedal{
    .node = 6,
    .vendor_id = 0x05f3,
    .product_id = 0x00ff,
    .maker = "VEC",
    .product = "Footpedal",
    .descriptor = testing::hex("05 0c 09 03 a1 01 05 09 19 01 29 03 15 00 25 01 75 01 95 03 81 02 "
                               "95 0d 81 03 c0")};
// Only the descriptor's reports 1 (63 bytes in) and 2 (47 out).
inline const MockHid kDualSense{
    .node = 7,
    .vendor_id = 0x054c,
    .product_id = 0x0ce6,
    .maker = "Sony",
    .product = "DualSense Wireless Controller",
    .descriptor = testing::hex("05 01 09 05 a1 01 15 00 26 ff 00 75 08 06 00 ff | 85 01 09 20 "
                               "95 3f 81 02 | 85 02 09 21 95 2f 91 02 | c0")};
inline const MockHid kJoystick{.node = 8,
                               .vendor_id = 0x1209,
                               .product_id = 0xffb0,
                               .maker = "Testing",
                               .product = "FFB stick",
                               .descriptor = testing::open_ffboard_descriptor()};
// The second layout of the tables: other report numbers, ranges and order of the controls.
inline const MockHid kRhino{.node = 13,
                            .vendor_id = 0xffff,
                            .product_id = 0x2055,
                            .maker = "VPforce",
                            .product = "Rhino",
                            .descriptor = testing::rhino_descriptor()};

// kJoystick's answers when its effects are created: one block for each.
inline HidScript joystick_features() {
    return HidScript()
        .sets_feature("11 08 00 00")
        .answers_feature("12 01 01 00 01")
        .sets_feature("11 01 00 00")
        .answers_feature("12 02 01 00 01")
        .sets_feature("11 09 00 00")
        .answers_feature("12 03 01 00 01")
        .sets_feature("11 0b 00 00")
        .answers_feature("12 04 01 00 01");
}

}  // namespace onggi::testing
