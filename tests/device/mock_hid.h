// HID devices described to umockdev, so that the real hidapi and libudev find, open, read and write them. For
// tests, on one thread, in a program that runs under umockdev-wrapper.
#pragma once

#include <umockdev.h>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "tests/support/temporary_folder.h"

namespace onggi::testing {

struct MockHid {
    int node = 0;  // /dev/hidraw<node>
    std::uint16_t vendor_id = 0;
    std::uint16_t product_id = 0;
    std::string maker = {};
    std::string product = {};
    std::vector<std::uint8_t> descriptor = {};
    bool is_bluetooth = false;

    [[nodiscard]] std::string path() const { return "/dev/hidraw" + std::to_string(node); }
};

// A device's reports and the expected writes, in order. A different write ends the program.
class HidScript {
  public:
    // The device sends this report (hex) `after_ms` after the previous step.
    HidScript& reports(std::string_view hex_bytes, int after_ms = 0);
    // The program must write this (hex).
    HidScript& expects(std::string_view hex_bytes);
    // The program sets a feature report; the answer to its next request for one.
    HidScript& sets_feature(std::string_view hex_bytes);
    HidScript& answers_feature(std::string_view hex_bytes);

    [[nodiscard]] const std::string& lines() const { return lines_; }
    [[nodiscard]] const std::string& ioctls() const { return ioctls_; }

  private:
    std::string lines_;
    std::string ioctls_;
};

// The test's end of a device without a script: reads the program's writes and sends reports at once.
class LiveHid {
  public:
    explicit LiveHid(int file) : file_(file) {}

    void report(std::string_view hex_bytes) const;
    // Returns the writes since the last call, as lower-case hex without blanks. Reports follow each other
    // without a separator: the test knows their lengths.
    std::string take_written() const;

  private:
    int file_;
};

class MockBus {
  public:
    MockBus();
    ~MockBus();
    MockBus(const MockBus&) = delete;
    MockBus& operator=(const MockBus&) = delete;

    // Fails the test if umockdev rejects the description.
    void plug_in(const MockHid& device, const HidScript& script = {});
    // For a device that was plugged in without a script.
    [[nodiscard]] LiveHid at(const MockHid& device);
    // Removes all permissions from its node.
    void forbid(const MockHid& device);
    // Removes its node and everything that belongs to it.
    void pull_out(const MockHid& device);

  private:
    UMockdevTestbed* testbed_;
    test::TemporaryFolder folder_;  // of the scripts
};

}  // namespace onggi::testing
