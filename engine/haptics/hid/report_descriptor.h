// Parses a HID report descriptor into a list of fields. Pure; any thread; allocates in proportion to the
// descriptor, which is at most 4096 bytes. Source: "Device Class Definition for HID" 1.11, sections 5 and
// 6.2.2 (USB Implementers' Forum). Devices are made to work with hosts, not with the standard: what Linux's
// hid-core accepts is accepted here.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "engine/core/result.h"

namespace onggi::haptics::hid {

// A usage page in the upper half, a usage in the lower: 0x00010030 is Generic Desktop, X.
using Usage = std::uint32_t;
constexpr Usage usage(std::uint16_t page, std::uint16_t id) {
    return (Usage{page} << 16U) | id;
}

enum class ReportKind : std::uint8_t { kInput, kOutput, kFeature };

struct UsageRange {
    Usage first = 0;
    Usage last = 0;  // inclusive; same page as first
};

// One Main item: `count` elements of `bit_size` bits, one after the other.
struct Field {
    ReportKind kind = ReportKind::kInput;
    std::uint8_t report_id = 0;    // 0: reports are not numbered
    std::uint32_t bit_offset = 0;  // of the first element, in the report's data, after the id byte if any
    std::uint32_t bit_size = 0;    // of one element, 1 to 32
    std::uint32_t count = 0;
    // The range of values. Some descriptors write 0..65535 with a negative 16-bit maximum: if the minimum is
    // not negative, or above the signed maximum, the maximum is read as unsigned.
    std::int64_t logical_min = 0;
    std::int64_t logical_max = 0;
    bool is_array =
        false;  // an element's value selects a usage (6.2.2.5); otherwise each element has its own usage
    bool is_relative = false;  // change since the last report
    std::vector<UsageRange> usages;
    int collection = -1;  // index of the innermost in ReportDescriptor::collections(); -1: outside any

    // Two's complement, or plain binary (6.2.2.7: signed if a limit is negative).
    [[nodiscard]] bool is_signed() const noexcept { return logical_min < 0; }
};

// A field and one of its elements.
struct Element {
    const Field* field = nullptr;
    std::uint32_t index = 0;

    explicit operator bool() const noexcept { return field != nullptr; }
};

struct Collection {
    Usage usage = 0;
    std::uint8_t type = 0;  // 0 physical, 1 application, 2 logical, ...
    int parent = -1;
};

// Bounds, none below the Linux kernel's; beyond one the descriptor is refused. Collections and fields are
// bounded by the descriptor's length.
constexpr std::size_t kMaxDescriptorBytes = 4096;
constexpr std::size_t kMaxPushDepth = 16;
constexpr std::uint32_t kMaxReportBits = 8 * 16384;

class ReportDescriptor {
  public:
    // Errors (bad input) name the offset of the item: a truncated item, a stack that over- or underflows, a
    // report size, count or id out of bounds, an unclosed collection.
    static Result<ReportDescriptor> parse(std::span<const std::uint8_t> bytes);

    [[nodiscard]] const std::vector<Field>& fields() const noexcept { return fields_; }
    [[nodiscard]] const std::vector<Collection>& collections() const noexcept { return collections_; }
    [[nodiscard]] bool numbers_reports() const noexcept { return numbers_reports_; }

    // The size of a report as hidapi passes it, including the id byte if reports are numbered. 0: there is no
    // such report.
    [[nodiscard]] std::size_t report_bytes(ReportKind kind, std::uint8_t id) const noexcept;

    // The first element with the usage `wanted` in a field inside a collection of usage `inside` (0:
    // anywhere). For an array that can select the usage, returns the array's first element.
    [[nodiscard]] Element find(ReportKind kind, Usage inside, Usage wanted) const noexcept;
    [[nodiscard]] bool is_inside(int collection, Usage outer) const noexcept;

  private:
    friend class DescriptorReader;
    struct ReportLength {
        ReportKind kind;
        std::uint8_t id;
        std::uint32_t bits;
    };

    std::vector<Field> fields_;
    std::vector<Collection> collections_;
    std::vector<ReportLength> lengths_;
    bool numbers_reports_ = false;
};

// An array's value for a usage: logical_min + the usage's index, from 0, in the list (6.2.2.5). Empty if the
// list lacks it.
[[nodiscard]] std::optional<std::int64_t> array_value_for(const Field& field, Usage wanted) noexcept;
// The inverse; 0 for a value that selects no usage.
[[nodiscard]] Usage usage_for_array_value(const Field& field, std::int64_t value) noexcept;

// The value of an element in a report's data (without the id byte). Empty if the report is too short.
[[nodiscard]] std::optional<std::int64_t> read_element(std::span<const std::uint8_t> data,
                                                       Element element) noexcept;
// Writes a value, clamped to the logical limits, into a report's data. Does nothing if it does not fit.
void write_element(std::span<std::uint8_t> data, Element element, std::int64_t value) noexcept;

}  // namespace onggi::haptics::hid
