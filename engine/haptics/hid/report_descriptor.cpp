#include "engine/haptics/hid/report_descriptor.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace onggi::haptics::hid {
namespace {

// The short item's prefix byte (6.2.2.2): size in bits 0-1, type in 2-3, tag in 4-7. Tag and type together:
enum ItemTag : std::uint8_t {
    kInput = 0x80,
    kOutput = 0x90,
    kFeature = 0xb0,
    kOpenCollection = 0xa0,
    kEndCollection = 0xc0,
    kUsagePage = 0x04,
    kLogicalMinimum = 0x14,
    kLogicalMaximum = 0x24,
    kReportSize = 0x74,
    kReportId = 0x84,
    kReportCount = 0x94,
    kPush = 0xa4,
    kPop = 0xb4,
    kUsage = 0x08,
    kUsageMinimum = 0x18,
    kUsageMaximum = 0x28,
    kDelimiter = 0xa8,
};
constexpr std::uint8_t kLongItem = 0xfe;
constexpr std::uint32_t kConstant = 1U << 0U;  // bits of an Input, Output or Feature item (6.2.2.5)
constexpr std::uint32_t kVariable = 1U << 1U;
constexpr std::uint32_t kRelative = 1U << 2U;

struct Item {
    std::size_t offset = 0;
    std::uint8_t tag = 0;
    std::size_t size = 0;  // of the data: 0, 1, 2 or 4
    std::uint32_t value = 0;

    [[nodiscard]] std::int64_t signed_value() const noexcept {
        if (size == 1) return static_cast<std::int8_t>(value);
        if (size == 2) return static_cast<std::int16_t>(value);
        return static_cast<std::int32_t>(value);
    }
};

struct Globals {
    std::uint16_t usage_page = 0;
    std::int64_t logical_min = 0;
    std::int64_t logical_max = 0;           // read as signed
    std::int64_t logical_max_unsigned = 0;  // the same bytes read as unsigned
    std::uint32_t report_size = 0;
    std::uint32_t report_count = 0;
    std::uint8_t report_id = 0;
};

// A usage from a Local item: with its own page, or with the page current at the Main item.
struct LocalUsage {
    std::uint32_t first = 0;
    std::uint32_t last = 0;
    bool has_page = false;
};

struct Locals {
    std::vector<LocalUsage> usages;
    std::optional<LocalUsage> minimum;
    std::optional<LocalUsage> maximum;
    bool inside_delimiter = false;
    bool has_alternative = false;  // the first usage between delimiters is the preferred one (6.2.2.8)
};

}  // namespace

// Reads item by item; the state is the item state table of 6.2.2.
class DescriptorReader {
  public:
    Result<ReportDescriptor> read(std::span<const std::uint8_t> bytes) {
        if (bytes.size() > kMaxDescriptorBytes) {
            return bad_input(fmt::format("report descriptor: expected at most {} bytes, found {}",
                                         kMaxDescriptorBytes, bytes.size()));
        }
        std::size_t at = 0;
        while (at < bytes.size()) {
            const std::uint8_t prefix = bytes[at];
            if (prefix == kLongItem) {
                // Reserved by 6.2.2.3; its second byte is the number of bytes to skip.
                const std::size_t size = at + 1 < bytes.size() ? std::size_t{3} + bytes[at + 1] : 3;
                if (bytes.size() - at < size) return refusal(at, "a whole long item", "the end");
                at += size;
                continue;
            }
            Item item{.offset = at, .tag = static_cast<std::uint8_t>(prefix & 0xfcU)};
            item.size = (prefix & 3U) == 3U ? 4 : prefix & 3U;
            if (bytes.size() - at - 1 < item.size) return refusal(at, "a whole item", "the end");
            for (std::size_t byte = 0; byte < item.size; ++byte)
                item.value |= std::uint32_t{bytes[at + 1 + byte]} << (8U * byte);
            if (auto taken = take(item); !taken) return taken.error();
            at += 1 + item.size;
        }
        if (!open_.empty()) return refusal(bytes.size(), "the end of every collection", "one left open");
        return std::move(result_);
    }

  private:
    static Error refusal(std::size_t offset, std::string_view expected, std::string_view found) {
        return bad_input(
            fmt::format("report descriptor: byte {}: expected {}, found {}", offset, expected, found));
    }

    Result<void> take(const Item& item) {
        switch (item.tag) {
            case kInput:
                return take_main(item, ReportKind::kInput);
            case kOutput:
                return take_main(item, ReportKind::kOutput);
            case kFeature:
                return take_main(item, ReportKind::kFeature);
            case kOpenCollection:
                open_collection(item);
                return {};
            case kEndCollection:
                locals_ = {};
                if (open_.empty()) return refusal(item.offset, "an open collection to end", "none");
                open_.pop_back();
                return {};
            case kUsage:
            case kUsageMinimum:
            case kUsageMaximum:
            case kDelimiter:
                return take_local(item);
            default:
                return take_global(item);
        }
    }

    Result<void> take_global(const Item& item) {
        switch (item.tag) {
            case kUsagePage:
                globals_.usage_page = static_cast<std::uint16_t>(item.value);
                return {};
            case kLogicalMinimum:
                globals_.logical_min = item.signed_value();
                return {};
            case kLogicalMaximum:
                globals_.logical_max = item.signed_value();
                globals_.logical_max_unsigned = item.value;
                return {};
            case kReportSize:
                if (item.value > kMaxReportBits)
                    return refusal(item.offset, fmt::format("a report size up to {}", kMaxReportBits),
                                   fmt::format("{}", item.value));
                globals_.report_size = item.value;
                return {};
            case kReportCount:
                if (item.value > kMaxReportBits)
                    return refusal(item.offset, fmt::format("a report count up to {}", kMaxReportBits),
                                   fmt::format("{}", item.value));
                globals_.report_count = item.value;
                return {};
            case kReportId:
                if (item.value == 0 || item.value > 255)
                    return refusal(item.offset, "a report id of 1 to 255", fmt::format("{}", item.value));
                globals_.report_id = static_cast<std::uint8_t>(item.value);
                result_.numbers_reports_ = true;
                return {};
            case kPush:
                if (pushed_.size() == kMaxPushDepth)
                    return refusal(item.offset, fmt::format("at most {} pushes", kMaxPushDepth), "one more");
                pushed_.push_back(globals_);
                return {};
            case kPop:
                if (pushed_.empty()) return refusal(item.offset, "something pushed to pop", "nothing");
                globals_ = pushed_.back();
                pushed_.pop_back();
                return {};
            default:
                return {};  // physical limits, units, designators, strings, reserved tags: not used here
        }
    }

    Result<void> take_local(const Item& item) {
        if (item.tag == kDelimiter) {
            locals_.inside_delimiter = item.value == 1;
            locals_.has_alternative = false;
            return {};
        }
        LocalUsage local{.first = item.value, .last = item.value, .has_page = item.size == 4};
        if (item.tag == kUsage) {
            if (locals_.inside_delimiter && locals_.has_alternative) return {};
            locals_.has_alternative = true;
            locals_.usages.push_back(local);
            return {};
        }
        (item.tag == kUsageMinimum ? locals_.minimum : locals_.maximum) = local;
        if (!locals_.minimum || !locals_.maximum) return {};
        local = {.first = locals_.minimum->first,
                 .last = locals_.maximum->first,
                 .has_page = locals_.minimum->has_page};
        locals_.minimum.reset();
        locals_.maximum.reset();
        // A maximum may omit its page and take the minimum's.
        if (local.has_page && (local.last >> 16U) == 0) local.last |= local.first & 0xffff0000U;
        if (!local.has_page) local.last &= 0xffffU;
        // A maximum below its minimum or on another page bounds nothing: the usages count on from the
        // minimum, as in Linux.
        if (local.last < local.first || (local.last >> 16U) != (local.first >> 16U))
            local.last = local.first | 0xffffU;
        locals_.usages.push_back(
            local);  // ranges are not expanded, so memory is bounded by the descriptor's length
        return {};
    }

    [[nodiscard]] Usage with_page(const LocalUsage& local, std::uint32_t id) const noexcept {
        return local.has_page ? id : usage(globals_.usage_page, static_cast<std::uint16_t>(id));
    }

    void open_collection(const Item& item) {
        Collection collection{.type = static_cast<std::uint8_t>(item.value), .parent = innermost()};
        if (!locals_.usages.empty())
            collection.usage = with_page(locals_.usages.front(), locals_.usages.front().first);
        locals_ = {};
        open_.push_back(static_cast<int>(result_.collections_.size()));
        result_.collections_.push_back(collection);
    }

    Result<void> take_main(const Item& item, ReportKind kind) {
        const Locals locals = std::exchange(locals_, {});
        auto& lengths = result_.lengths_;
        auto length = std::find_if(lengths.begin(), lengths.end(), [&](const auto& known) {
            return known.kind == kind && known.id == globals_.report_id;
        });
        if (length == lengths.end()) {
            lengths.push_back({kind, globals_.report_id, 0});
            length = lengths.end() - 1;
        }
        const std::uint64_t bits = std::uint64_t{globals_.report_size} * globals_.report_count;
        if (bits + length->bits > kMaxReportBits)
            return refusal(item.offset, fmt::format("reports of at most {} bits", kMaxReportBits),
                           fmt::format("{}", bits + length->bits));
        const std::uint32_t bit_offset = length->bits;
        length->bits += static_cast<std::uint32_t>(bits);

        // Padding, and a field too wide for a number, only advances the offset.
        if ((item.value & kConstant) != 0 || globals_.report_size > 32 || bits == 0) return {};
        Field field;
        field.kind = kind;
        field.report_id = globals_.report_id;
        field.bit_offset = bit_offset;
        field.bit_size = globals_.report_size;
        field.count = globals_.report_count;
        field.logical_min = globals_.logical_min;
        const bool is_signed = globals_.logical_min < 0 && globals_.logical_max >= globals_.logical_min;
        field.logical_max = is_signed ? globals_.logical_max : globals_.logical_max_unsigned;
        if (field.logical_max < field.logical_min)
            return refusal(item.offset, "a logical maximum at or above the minimum",
                           fmt::format("{} to {}", field.logical_min, field.logical_max));
        if (locals.usages.empty()) return {};  // names nothing
        field.is_array = (item.value & kVariable) == 0;
        field.is_relative = (item.value & kRelative) != 0;
        field.collection = innermost();
        field.usages.reserve(locals.usages.size());
        for (const LocalUsage& local : locals.usages)
            field.usages.push_back({with_page(local, local.first), with_page(local, local.last)});
        result_.fields_.push_back(std::move(field));
        return {};
    }

    [[nodiscard]] int innermost() const noexcept { return open_.empty() ? -1 : open_.back(); }

    ReportDescriptor result_;
    Globals globals_;
    std::vector<Globals> pushed_;
    Locals locals_;
    std::vector<int> open_;
};

Result<ReportDescriptor> ReportDescriptor::parse(std::span<const std::uint8_t> bytes) {
    return DescriptorReader().read(bytes);
}

std::size_t ReportDescriptor::report_bytes(ReportKind kind, std::uint8_t id) const noexcept {
    for (const ReportLength& length : lengths_) {
        if (length.kind == kind && length.id == id)
            return (length.bits + 7U) / 8U + (numbers_reports_ ? 1U : 0U);
    }
    return 0;
}

bool ReportDescriptor::is_inside(int collection, Usage outer) const noexcept {
    // A parent's index is always lower than its child's, so this ends.
    for (; collection >= 0; collection = collections_[static_cast<std::size_t>(collection)].parent) {
        if (collections_[static_cast<std::size_t>(collection)].usage == outer) return true;
    }
    return false;
}

Element ReportDescriptor::find(ReportKind kind, Usage inside, Usage wanted) const noexcept {
    for (const Field& field : fields_) {
        if (field.kind != kind || (inside != 0 && !is_inside(field.collection, inside))) continue;
        std::uint64_t place = 0;
        for (const UsageRange& range : field.usages) {
            if (wanted >= range.first && wanted <= range.last) {
                if (field.is_array) return {&field, 0};
                const std::uint64_t index = place + (wanted - range.first);
                if (index < field.count) return {&field, static_cast<std::uint32_t>(index)};
            }
            place += std::uint64_t{range.last} - range.first + 1;
        }
    }
    return {};
}

std::optional<std::int64_t> array_value_for(const Field& field, Usage wanted) noexcept {
    std::int64_t place = 0;
    for (const UsageRange& range : field.usages) {
        if (wanted >= range.first && wanted <= range.last)
            return field.logical_min + place + (wanted - range.first);
        place += std::int64_t{range.last} - range.first + 1;
    }
    return std::nullopt;
}

Usage usage_for_array_value(const Field& field, std::int64_t value) noexcept {
    std::int64_t place = value - field.logical_min;
    if (place < 0) return 0;
    for (const UsageRange& range : field.usages) {
        const std::int64_t length = std::int64_t{range.last} - range.first + 1;
        if (place < length) return range.first + static_cast<Usage>(place);
        place -= length;
    }
    return 0;
}

namespace {

// The bit offset of an element; empty if it exceeds the data.
std::optional<std::size_t> first_bit(std::size_t data_bytes, Element element) noexcept {
    if (!element || element.index >= element.field->count) return std::nullopt;
    const std::size_t first =
        element.field->bit_offset + std::size_t{element.index} * element.field->bit_size;
    if (first + element.field->bit_size > data_bytes * 8) return std::nullopt;
    return first;
}

}  // namespace

std::optional<std::int64_t> read_element(std::span<const std::uint8_t> data, Element element) noexcept {
    const auto first = first_bit(data.size(), element);
    if (!first) return std::nullopt;
    std::uint64_t bits = 0;
    for (std::size_t bit = 0; bit < element.field->bit_size; ++bit) {
        const std::size_t at = *first + bit;
        bits |= ((std::uint64_t{data[at / 8]} >> (at % 8)) & 1U) << bit;
    }
    if (element.field->is_signed() && (bits >> (element.field->bit_size - 1) & 1U) != 0)
        bits |= ~std::uint64_t{0} << element.field->bit_size;
    return static_cast<std::int64_t>(bits);
}

void write_element(std::span<std::uint8_t> data, Element element, std::int64_t value) noexcept {
    const auto first = first_bit(data.size(), element);
    if (!first) return;
    value = std::clamp(value, element.field->logical_min, element.field->logical_max);
    // A declared range may exceed the field's bits; a wrapped value would reverse a force.
    const auto bits = element.field->bit_size;
    const bool is_signed = element.field->is_signed();
    const std::int64_t most = (std::int64_t{1} << (is_signed ? bits - 1 : bits)) - 1;
    value = std::clamp(value, is_signed ? -most - 1 : 0, most);
    for (std::size_t bit = 0; bit < element.field->bit_size; ++bit) {
        const std::size_t at = *first + bit;
        const auto mask = static_cast<std::uint8_t>(1U << (at % 8));
        const bool is_set = ((static_cast<std::uint64_t>(value) >> bit) & 1U) != 0;
        data[at / 8] = static_cast<std::uint8_t>(is_set ? data[at / 8] | mask : data[at / 8] & ~mask);
    }
}

}  // namespace onggi::haptics::hid
