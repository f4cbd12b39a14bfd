// A device with the validation layer: any message fails the test. Main thread.
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <utility>

#include "engine/vk/device.h"

namespace onggi::support {

class ValidatedDevice : public ::testing::Test {
  protected:
    void SetUp() override {
        auto opened = vk::OffscreenDevice::open({.validation = true});
        ASSERT_TRUE(opened) << opened.error().message;
        instance_ = std::move(opened->instance);
        device_ = std::move(opened->device);
    }
    // Objects of the device must be destroyed first.
    void TearDown() override {
        device_.reset();
        if (!instance_) return;
        for (const std::string& message : instance_->messages())
            ADD_FAILURE() << message;
    }

    std::unique_ptr<vk::Instance> instance_;
    std::unique_ptr<vk::Device> device_;
};

}  // namespace onggi::support
