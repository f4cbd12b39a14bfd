// The report descriptor parser and the fields it finds, against descriptors written item by item.
#include "engine/haptics/hid/report_descriptor.h"

#include <gtest/gtest.h>

#include <random>

#include "tests/support/hid_descriptor_builder.h"
#include "tests/support/refusal.h"

namespace onggi::haptics::hid {
namespace {

using testing::HidDescriptorBuilder;

ReportDescriptor parsed(const HidDescriptorBuilder& builder) {
    auto descriptor = ReportDescriptor::parse(builder.bytes());
    EXPECT_TRUE(descriptor) << (descriptor ? "" : descriptor.error().message);
    return descriptor ? std::move(descriptor).value() : ReportDescriptor{};
}

std::string refusal_of(const std::vector<std::uint8_t>& bytes) {
    return test::refusal(ReportDescriptor::parse(bytes));
}

TEST(ReportDescriptor, PlacesEachFieldBehindTheOneBefore) {
    const ReportDescriptor descriptor = parsed(HidDescriptorBuilder()
                                                   .page(0x01)
                                                   .open(0x04, 1)
                                                   .report_id(7)
                                                   .page(0x09)
                                                   .usage_range(1, 10)
                                                   .logical(0, 1)
                                                   .size(1, 10)
                                                   .input()
                                                   .size(1, 6)
                                                   .input(HidDescriptorBuilder::kConstant)
                                                   .page(0x01)
                                                   .usages({0x30, 0x31})
                                                   .logical(-32767, 32767)
                                                   .size(16, 2)
                                                   .input()
                                                   .end());
    ASSERT_EQ(descriptor.fields().size(), 2U) << "padding is no field";
    EXPECT_TRUE(descriptor.numbers_reports());
    EXPECT_EQ(descriptor.report_bytes(ReportKind::kInput, 7), 7U);
    EXPECT_EQ(descriptor.report_bytes(ReportKind::kInput, 8), 0U);
    EXPECT_EQ(descriptor.report_bytes(ReportKind::kOutput, 7), 0U);

    const Element button_10 = descriptor.find(ReportKind::kInput, 0, usage(0x09, 10));
    const Element y = descriptor.find(ReportKind::kInput, usage(0x01, 0x04), usage(0x01, 0x31));
    ASSERT_TRUE(button_10);
    ASSERT_TRUE(y);
    EXPECT_EQ(button_10.index, 9U);
    EXPECT_EQ(y.field->bit_offset, 16U);
    const std::array<std::uint8_t, 6> data{0x00, 0x02, 0x34, 0x12, 0xfe, 0xff};
    EXPECT_EQ(read_element(data, button_10), 1);
    EXPECT_EQ(read_element(data, y), -2);
    EXPECT_FALSE(descriptor.find(ReportKind::kInput, usage(0x01, 0x05), usage(0x01, 0x31)));
    EXPECT_FALSE(descriptor.find(ReportKind::kOutput, 0, usage(0x01, 0x31)));
}

TEST(ReportDescriptor, KeepsInputOutputAndFeatureReportsOfOneNumberApart) {
    const ReportDescriptor descriptor = parsed(HidDescriptorBuilder()
                                                   .page(0xff00)
                                                   .open(1, 1)
                                                   .report_id(1)
                                                   .logical(0, 255)
                                                   .size(8, 3)
                                                   .usage(1)
                                                   .input()
                                                   .usage(2)
                                                   .output()
                                                   .size(8, 9)
                                                   .usage(3)
                                                   .feature()
                                                   .end());
    EXPECT_EQ(descriptor.report_bytes(ReportKind::kInput, 1), 4U);
    EXPECT_EQ(descriptor.report_bytes(ReportKind::kOutput, 1), 4U);
    EXPECT_EQ(descriptor.report_bytes(ReportKind::kFeature, 1), 10U);
    EXPECT_EQ(descriptor.fields()[1].bit_offset, 0U);
}

TEST(ReportDescriptor, ReadsAMaximumThatLooksNegativeAsUnsigned) {
    // 26 ff ff is -1 as a signed item; with a minimum of 0 it means 65535.
    const std::vector<std::uint8_t> bytes{0x05, 0x01, 0x09, 0x30, 0x15, 0x00, 0x26, 0xff,
                                          0xff, 0x75, 0x10, 0x95, 0x01, 0x81, 0x02};
    const auto descriptor = ReportDescriptor::parse(bytes);
    ASSERT_TRUE(descriptor);
    EXPECT_EQ(descriptor->fields().front().logical_max, 65535);
    EXPECT_FALSE(descriptor->numbers_reports());
    EXPECT_EQ(descriptor->report_bytes(ReportKind::kInput, 0), 2U);
}

TEST(ReportDescriptor, RestoresTheGlobalsThatWerePushed) {
    const ReportDescriptor descriptor = parsed(HidDescriptorBuilder()
                                                   .page(0x01)
                                                   .logical(0, 100)
                                                   .size(8, 1)
                                                   .push()
                                                   .page(0x0f)
                                                   .logical(-5, 5)
                                                   .size(4, 2)
                                                   .usage(0x22)
                                                   .output()
                                                   .pop()
                                                   .usage(0x30)
                                                   .output());
    ASSERT_EQ(descriptor.fields().size(), 2U);
    EXPECT_EQ(descriptor.fields()[0].usages.front().first, usage(0x0f, 0x22));
    EXPECT_EQ(descriptor.fields()[1].usages.front().first, usage(0x01, 0x30));
    EXPECT_EQ(descriptor.fields()[1].logical_max, 100);
    EXPECT_EQ(descriptor.fields()[1].bit_offset, 8U);
}

TEST(ReportDescriptor, TellsAnArraysUsageByItsPlaceInTheList) {
    const ReportDescriptor descriptor = parsed(HidDescriptorBuilder()
                                                   .page(0x0f)
                                                   .open(0x25)
                                                   .usages({0x26, 0x30, 0x40, 0x41})
                                                   .logical(1, 4)
                                                   .size(8, 1)
                                                   .output(HidDescriptorBuilder::kArray)
                                                   .end());
    const Element type = descriptor.find(ReportKind::kOutput, usage(0x0f, 0x25), usage(0x0f, 0x40));
    ASSERT_TRUE(type);
    EXPECT_TRUE(type.field->is_array);
    EXPECT_EQ(array_value_for(*type.field, usage(0x0f, 0x26)), 1);
    EXPECT_EQ(array_value_for(*type.field, usage(0x0f, 0x40)), 3);
    EXPECT_FALSE(array_value_for(*type.field, usage(0x0f, 0x42)));
    EXPECT_EQ(usage_for_array_value(*type.field, 4), usage(0x0f, 0x41));
    EXPECT_EQ(usage_for_array_value(*type.field, 5), 0U);
    EXPECT_EQ(usage_for_array_value(*type.field, 0), 0U);
}

TEST(ReportDescriptor, TakesTheFirstOfAlternativeUsages) {
    const ReportDescriptor descriptor = parsed(HidDescriptorBuilder()
                                                   .page(0x01)
                                                   .item(0xa8, 1)
                                                   .usages({0x30, 0x38})
                                                   .item(0xa8, 0)
                                                   .usage(0x31)
                                                   .logical(0, 1)
                                                   .size(1, 2)
                                                   .input());
    EXPECT_EQ(descriptor.find(ReportKind::kInput, 0, usage(1, 0x30)).index, 0U);
    EXPECT_EQ(descriptor.find(ReportKind::kInput, 0, usage(1, 0x31)).index, 1U);
    EXPECT_FALSE(descriptor.find(ReportKind::kInput, 0, usage(1, 0x38)));
}

TEST(ReportDescriptor, PassesOverLongItems) {
    HidDescriptorBuilder builder;
    builder.page(0x01).bare(0xfe).bare(2).bare(0x99).bare(0x81).bare(0x02);
    builder.usage(0x30).logical(0, 255).size(8, 1).input();
    EXPECT_EQ(parsed(builder).fields().size(), 1U);
}

TEST(ReportDescriptor, RejectsTruncatedAndOutOfBoundsItemsWithTheirOffset) {
    const std::vector<std::uint8_t> whole = HidDescriptorBuilder().page(0x01).open(0x04, 1).end().bytes();
    ASSERT_EQ(refusal_of(whole), "accepted");
    EXPECT_EQ(refusal_of({0x05, 0x01, 0x26, 0xff}),
              "report descriptor: byte 2: expected a whole item, found the end");
    EXPECT_EQ(refusal_of({0xfe, 0x04, 0x00}),
              "report descriptor: byte 0: expected a whole long item, found the end");
    EXPECT_EQ(refusal_of({0xc0}),
              "report descriptor: byte 0: expected an open collection to end, found none");
    EXPECT_EQ(refusal_of({0xa1, 0x01}),
              "report descriptor: byte 2: expected the end of every collection, found one left open");
    EXPECT_EQ(refusal_of({0x85, 0x00}),
              "report descriptor: byte 0: expected a report id of 1 to 255, found 0");
    EXPECT_EQ(refusal_of({0xb4}),
              "report descriptor: byte 0: expected something pushed to pop, found nothing");
    EXPECT_EQ(refusal_of({0x97, 0xff, 0xff, 0xff, 0xff}),
              "report descriptor: byte 0: expected a report count up to 131072, found 4294967295");
    EXPECT_EQ(refusal_of({0x15, 0x05, 0x25, 0x01, 0x75, 0x08, 0x95, 0x01, 0x81, 0x02}),
              "report descriptor: byte 8: expected a logical maximum at or above the minimum, found 5 to 1");
}

TEST(ReportDescriptor, RejectsHostileNestingAndSizes) {
    EXPECT_NE(refusal_of(std::vector<std::uint8_t>(4096, 0xa0)).find("found one left open"),
              std::string::npos);
    EXPECT_NE(refusal_of(std::vector<std::uint8_t>(4096, 0xa4)).find("at most 16 pushes"), std::string::npos);
    EXPECT_NE(refusal_of(std::vector<std::uint8_t>(4097, 0xa4)).find("at most 4096 bytes"),
              std::string::npos);
    // 32768 elements of 32768 bits each: no memory is taken for them.
    EXPECT_NE(refusal_of({0x76, 0x00, 0x80, 0x96, 0x00, 0x80, 0x81, 0x02}).find("at most 131072 bits"),
              std::string::npos);
    std::vector<std::uint8_t> many{0x75, 0x01, 0x95, 0x01};
    for (int field = 0; field < 2040; ++field)
        many.insert(many.end(), {0x81, 0x02});
    EXPECT_EQ(refusal_of(many), "accepted");
}

// Each is outside the standard, or was outside a bound of this parser, and devices that have it work in
// Linux.
TEST(ReportDescriptor, AcceptsWhatLinuxAccepts) {
    std::vector<std::uint8_t> deep(1000, 0xa0);
    deep.insert(deep.end(), 1000, 0xc0);
    EXPECT_EQ(refusal_of(deep), "accepted") << "collections a thousand deep";
    EXPECT_EQ(refusal_of({0x75, 0x20, 0x96, 0xff, 0x0f, 0x09, 0x01, 0x81, 0x02}), "accepted")
        << "a report of 16380 bytes";
    EXPECT_EQ(refusal_of({0x75, 0x01, 0x95, 0x01, 0xb1, 0x01}), "accepted") << "padding without a collection";
    std::vector<std::uint8_t> fields{0x75, 0x01, 0x95, 0x01};
    fields.resize(4096, 0x80);
    EXPECT_EQ(refusal_of(fields), "accepted") << "four thousand fields that name nothing";

    const ReportDescriptor reversed =
        parsed(HidDescriptorBuilder().page(0x09).usage_range(5, 1).logical(0, 1).size(1, 3).input());
    EXPECT_EQ(reversed.find(ReportKind::kInput, 0, usage(0x09, 7)).index, 2U)
        << "a maximum below its minimum: the usages count on from the minimum";
    const ReportDescriptor other_page = parsed(HidDescriptorBuilder()
                                                   .page(0x09)
                                                   .usage_range(0x00090001, 0x000c0003)
                                                   .logical(0, 1)
                                                   .size(1, 3)
                                                   .input());
    EXPECT_EQ(other_page.find(ReportKind::kInput, 0, usage(0x09, 3)).index, 2U);

    // A maximum before its minimum: Linux reads 25 80 as 128 then; -1 to -128 is no range.
    const ReportDescriptor range = parsed(HidDescriptorBuilder()
                                              .page(0x01)
                                              .usage(0x30)
                                              .bare(0x25)
                                              .bare(0x80)
                                              .bare(0x15)
                                              .bare(0xff)
                                              .size(16, 1)
                                              .input());
    ASSERT_EQ(range.fields().size(), 1U);
    EXPECT_EQ(range.fields().front().logical_max, 128);
}

TEST(ReportDescriptor, NeverReadsOutsideForAnyBytes) {
    // A seeded sweep; the fuzzer goes further.
    std::mt19937 random(7);
    for (int round = 0; round < 20'000; ++round) {
        std::vector<std::uint8_t> bytes(random() % 64);
        for (auto& byte : bytes)
            byte = static_cast<std::uint8_t>(random());
        const auto descriptor = ReportDescriptor::parse(bytes);
        if (!descriptor) continue;
        std::array<std::uint8_t, 8> data{};
        for (const Field& field : descriptor->fields()) {
            for (std::uint32_t index = 0; index < std::min(field.count, 70U); ++index) {
                write_element(data, {&field, index}, field.logical_max);
                (void)read_element(data, {&field, index});
            }
        }
    }
}

TEST(FieldValues, ComeBackAsTheyWereWrittenAtEveryOffsetAndWidth) {
    std::mt19937 random(11);
    for (std::uint32_t bits = 1; bits <= 32; ++bits) {
        for (std::uint32_t offset = 0; offset < 16; ++offset) {
            for (const bool is_signed : {false, true}) {
                Field field;
                field.bit_offset = offset;
                field.bit_size = bits;
                field.count = 2;
                const std::int64_t span = std::int64_t{1} << (bits - (is_signed ? 1 : 0));
                field.logical_min = is_signed ? -span : 0;
                field.logical_max = span - 1;
                std::array<std::uint8_t, 12> data{};
                for (auto& byte : data)
                    byte = static_cast<std::uint8_t>(random());
                const auto before = data;
                const std::int64_t value =
                    field.logical_min +
                    static_cast<std::int64_t>(
                        random() % static_cast<std::uint64_t>(field.logical_max - field.logical_min + 1));
                write_element(data, {&field, 1}, value);
                EXPECT_EQ(read_element(data, {&field, 1}), value) << bits << " bits at " << offset;
                EXPECT_EQ(read_element(data, {&field, 0}), read_element(before, {&field, 0}))
                    << "the neighbour was touched";
            }
        }
    }
}

TEST(FieldValues, AreClampedToTheDescriptorAndTheBits) {
    Field field;
    field.bit_size = 8;
    field.count = 1;
    field.logical_min = -100;
    field.logical_max = 100;
    std::array<std::uint8_t, 1> data{};
    write_element(data, {&field, 0}, 5000);
    EXPECT_EQ(read_element(data, {&field, 0}), 100);
    write_element(data, {&field, 0}, -5000);
    EXPECT_EQ(read_element(data, {&field, 0}), -100);
    field.logical_max = 1000;  // more than 8 bits hold: must not wrap to a negative number
    write_element(data, {&field, 0}, 5000);
    EXPECT_EQ(read_element(data, {&field, 0}), 127);
    EXPECT_FALSE(read_element(std::span<const std::uint8_t>(), {&field, 0}));
    EXPECT_FALSE(read_element(data, {&field, 1}));
    EXPECT_FALSE(read_element(data, {}));
}

}  // namespace
}  // namespace onggi::haptics::hid
