// Writes HID report descriptors item by item, for tests: what the parser must read back. Any thread.
// Source: "Device Class Definition for HID" 1.11, section 6.2.2.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <span>
#include <vector>

namespace onggi::testing {

class HidDescriptorBuilder {
  public:
    // Shortest form that holds the value, as a signed number where it may be negative.
    HidDescriptorBuilder& item(std::uint8_t tag, std::int64_t value, bool is_signed = false) {
        int size = 1;
        if (is_signed ? value < -128 || value > 127 : value > 0xff) size = 2;
        if (is_signed ? value < -32768 || value > 32767 : value > 0xffff) size = 4;
        bytes_.push_back(static_cast<std::uint8_t>(tag | (size == 4 ? 3 : size)));
        for (int byte = 0; byte < size; ++byte)
            bytes_.push_back(static_cast<std::uint8_t>(static_cast<std::uint64_t>(value) >> (8 * byte)));
        return *this;
    }
    HidDescriptorBuilder& bare(std::uint8_t tag) {
        bytes_.push_back(tag);
        return *this;
    }

    HidDescriptorBuilder& page(std::uint16_t page) { return item(0x04, page); }
    HidDescriptorBuilder& usage(std::uint32_t id) { return item(0x08, id); }
    HidDescriptorBuilder& usages(std::initializer_list<std::uint32_t> ids) {
        for (const std::uint32_t id : ids)
            usage(id);
        return *this;
    }
    HidDescriptorBuilder& usage_range(std::uint32_t first, std::uint32_t last) {
        return item(0x18, first).item(0x28, last);
    }
    HidDescriptorBuilder& logical(std::int64_t least, std::int64_t most) {
        return item(0x14, least, true).item(0x24, most, true);
    }
    HidDescriptorBuilder& size(std::uint32_t bits, std::uint32_t count) {
        return item(0x74, bits).item(0x94, count);
    }
    HidDescriptorBuilder& report_id(std::uint32_t id) { return item(0x84, id); }
    HidDescriptorBuilder& push() { return bare(0xa4); }
    HidDescriptorBuilder& pop() { return bare(0xb4); }

    // type: 0 physical, 1 application, 2 logical
    HidDescriptorBuilder& open(std::uint32_t usage_id, std::uint8_t type = 2) {
        return usage(usage_id).item(0xa0, type);
    }
    HidDescriptorBuilder& end() { return bare(0xc0); }

    static constexpr std::uint8_t kArray = 0x00;
    static constexpr std::uint8_t kConstant = 0x03;
    static constexpr std::uint8_t kVariable = 0x02;
    HidDescriptorBuilder& input(std::uint8_t flags = kVariable) { return item(0x80, flags); }
    HidDescriptorBuilder& output(std::uint8_t flags = kVariable) { return item(0x90, flags); }
    HidDescriptorBuilder& feature(std::uint8_t flags = kVariable) { return item(0xb0, flags); }

    [[nodiscard]] const std::vector<std::uint8_t>& bytes() const { return bytes_; }

  private:
    std::vector<std::uint8_t> bytes_;
};

}  // namespace onggi::testing
