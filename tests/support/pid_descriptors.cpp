#include "tests/support/pid_descriptors.h"

#include "tests/support/hid_descriptor_builder.h"

namespace onggi::testing {
namespace {

using Builder = HidDescriptorBuilder;

// The differences between makers.
struct Maker {
    std::uint8_t set_effect, condition, constant, operation, block_free, control, gain_report;  // outputs
    std::uint8_t state;                                                                         // input
    std::uint8_t create, block_load;                                                            // features
    std::uint32_t blocks;
    std::int64_t full;       // of forces, coefficients and places
    std::int64_t gain_full;  // of an effect's gain
    std::uint32_t gain_bits;
    std::int64_t direction_full;
    std::uint32_t direction_bits;
    bool start_delay_first, start_delay_last, type_specific_offset;
    bool is_sparse;  // no parameter block offset, negative side, dead band or collection around the control
                     // list
};

constexpr Maker kOpenFfboard{.set_effect = 0x01,
                             .condition = 0x03,
                             .constant = 0x05,
                             .operation = 0x0a,
                             .block_free = 0x0b,
                             .control = 0x0c,
                             .gain_report = 0x0d,
                             .state = 0x02,
                             .create = 0x11,
                             .block_load = 0x12,
                             .blocks = 40,
                             .full = 32767,
                             .gain_full = 255,
                             .gain_bits = 8,
                             .direction_full = 36000,
                             .direction_bits = 16,
                             .start_delay_first = true,
                             .start_delay_last = false,
                             .type_specific_offset = true,
                             .is_sparse = false};
constexpr Maker kRhino{.set_effect = 101,
                       .condition = 103,
                       .constant = 105,
                       .operation = 110,
                       .block_free = 111,
                       .control = 112,
                       .gain_report = 113,
                       .state = 2,
                       .create = 5,
                       .block_load = 6,
                       .blocks = 40,
                       .full = 4096,
                       .gain_full = 4096,
                       .gain_bits = 16,
                       .direction_full = 255,
                       .direction_bits = 8,
                       .start_delay_first = false,
                       .start_delay_last = true,
                       .type_specific_offset = false,
                       .is_sparse = false};
constexpr Maker kSparse{.set_effect = 1,
                        .condition = 3,
                        .constant = 5,
                        .operation = 10,
                        .block_free = 11,
                        .control = 12,
                        .gain_report = 13,
                        .state = 2,
                        .create = 5,
                        .block_load = 6,
                        .blocks = 14,
                        .full = 10000,
                        .gain_full = 255,
                        .gain_bits = 8,
                        .direction_full = 255,
                        .direction_bits = 8,
                        .start_delay_first = false,
                        .start_delay_last = false,
                        .type_specific_offset = false,
                        .is_sparse = true};

constexpr std::initializer_list<std::uint32_t> kTypes{0x26, 0x27, 0x30, 0x31, 0x32, 0x33,
                                                      0x34, 0x40, 0x41, 0x42, 0x43};

void block_index(Builder& to, const Maker& maker) {
    to.usage(0x22).logical(1, maker.blocks).size(8, 1).output();
}

void effect_type(Builder& to) {
    to.open(0x25).usages(kTypes).logical(1, 11).size(8, 1);
}

void set_effect(Builder& to, const Maker& maker) {
    to.open(0x21).report_id(maker.set_effect);
    block_index(to, maker);
    effect_type(to);
    to.output(Builder::kArray).end();
    to.usages({0x50, 0x54, 0x51}).logical(0, 32767).size(16, 3).output();
    if (maker.start_delay_first) to.usage(0xa7).size(16, 1).output();
    to.usage(0x52).logical(0, maker.gain_full).size(maker.gain_bits, 1).output();
    to.usage(0x53).logical(1, 8).size(8, 1).output();
    to.open(0x55).page(0x01).usages({0x30, 0x31}).logical(0, 1).size(1, 2).output().end();
    to.page(0x0f).usage(0x56).size(1, 1).output().size(1, 5).output(Builder::kConstant);
    to.open(0x57).page(0x0a).usages({1, 2}).logical(0, maker.direction_full);
    to.size(maker.direction_bits, 2).output().end().page(0x0f);
    if (maker.start_delay_last) to.usage(0xa7).logical(0, 32767).size(16, 1).output();
    if (maker.type_specific_offset)
        to.open(0x58).page(0x0a).usages({1, 2}).logical(0, 32767).size(16, 2).output().end().page(0x0f);
    to.end();
}

void set_condition(Builder& to, const Maker& maker) {
    to.open(0x5f).report_id(maker.condition);
    block_index(to, maker);
    if (!maker.is_sparse) {
        to.usage(0x23).logical(0, 3).size(4, 1).output();
        to.open(0x58).page(0x0a).usages({1, 2}).size(2, 2).output().end().page(0x0f);
    }
    to.usages({0x60, 0x61}).logical(-maker.full, maker.full).size(16, 2).output();
    if (!maker.is_sparse) to.usage(0x62).size(16, 1).output();
    to.usage(0x63).logical(0, maker.full).size(16, 1).output();
    if (!maker.is_sparse) to.usages({0x64, 0x65}).size(16, 2).output();
    to.end();
}

void orders(Builder& to, const Maker& maker, bool control_is_mask) {
    to.open(0x73).report_id(maker.constant);
    block_index(to, maker);
    to.usage(0x70).logical(-maker.full, maker.full).size(16, 1).output().end();

    to.open(0x77).report_id(maker.operation);
    block_index(to, maker);
    to.open(0x78).usages({0x79, 0x7a, 0x7b}).logical(1, 3).size(8, 1).output(Builder::kArray).end();
    to.usage(0x7c).logical(0, 255).size(8, 1).output().end();

    to.open(0x90).report_id(maker.block_free);
    block_index(to, maker);
    to.end();

    if (!maker.is_sparse) to.open(0x95);
    to.report_id(maker.control).open(0x96);
    if (control_is_mask) {
        to.usages({0x97, 0x98, 0x99, 0x9a, 0x9b, 0x9c}).logical(0, 1).size(1, 6).output();
        to.size(1, 2).output(Builder::kConstant);
    } else {
        to.usages({0x98, 0x97, 0x99, 0x9a, 0x9b, 0x9c}).logical(1, 6).size(8, 1).output(Builder::kArray);
    }
    to.end();
    if (!maker.is_sparse) to.end();

    to.open(0x7d).report_id(maker.gain_report).usage(0x7e);
    to.logical(0, maker.gain_full).size(maker.gain_bits, 1).output().end();
}

void features(Builder& to, const Maker& maker) {
    to.open(0xab).report_id(maker.create);
    effect_type(to);
    to.feature(Builder::kArray).end();
    to.page(0x01).usage(0x3b).logical(0, 511).size(10, 1).feature();
    to.size(6, 1).feature(Builder::kConstant).page(0x0f).end();

    to.open(0x89).report_id(maker.block_load);
    to.usage(0x22).logical(1, maker.blocks).size(8, 1).feature();
    to.open(0x8b).usages({0x8c, 0x8d, 0x8e}).logical(1, 3).size(8, 1).feature(Builder::kArray).end();
    to.usage(0xac).logical(0, 65535).size(16, 1).feature().end();
}

void state(Builder& to, const Maker& maker) {
    to.open(0x92).report_id(maker.state);
    to.usages({0x9f, 0xa0, 0xa4, 0xa6, 0x94}).logical(0, 1).size(1, 5).input();
    to.size(1, 3).input(Builder::kConstant).end();
}

Builder joystick(std::uint32_t buttons, std::initializer_list<std::uint32_t> axes, std::int64_t full) {
    Builder to;
    to.page(0x01).open(0x04, 1).report_id(1);
    if (buttons > 0) to.page(0x09).usage_range(1, buttons).logical(0, 1).size(1, buttons).input().page(0x01);
    to.open(0x01, 0).usages(axes).logical(-full, full);
    to.size(16, static_cast<std::uint32_t>(axes.size())).input().end();
    return to.page(0x0f);
}

}  // namespace

std::vector<std::uint8_t> open_ffboard_descriptor() {
    Builder to = joystick(64, {0x30, 0x31, 0x32, 0x33, 0x34, 0x35, 0x37, 0x36}, 32767);
    state(to, kOpenFfboard);
    set_effect(to, kOpenFfboard);
    set_condition(to, kOpenFfboard);
    orders(to, kOpenFfboard, true);
    features(to, kOpenFfboard);
    return to.end().bytes();
}

std::vector<std::uint8_t> rhino_descriptor() {
    Builder to = joystick(0, {0x30, 0x31, 0x32}, 4096);
    state(to, kRhino);
    set_effect(to, kRhino);
    set_condition(to, kRhino);
    orders(to, kRhino, false);
    features(to, kRhino);
    return to.end().bytes();
}

std::vector<std::uint8_t> sparse_descriptor() {
    Builder to = joystick(8, {0x30, 0x31}, 127);
    set_effect(to, kSparse);
    set_condition(to, kSparse);
    orders(to, kSparse, false);
    features(to, kSparse);
    return to.end().bytes();
}

}  // namespace onggi::testing
