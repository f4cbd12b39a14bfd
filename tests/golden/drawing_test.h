// A device that draws pictures under the eye of the validation layer: what it says fails the test. Main
// thread.
#pragma once

#include <gtest/gtest.h>

#include <memory>

#include "engine/vk/device.h"
#include "engine/vk/instance.h"

namespace onggi::golden {

class DrawingTest : public testing::Test {
  protected:
    void SetUp() override {
        auto instance = vk::Instance::create({.validation = true});
        ASSERT_TRUE(instance) << instance.error().message;
        instance_ = std::move(*instance);
        auto chosen = vk::choose_device(*instance_, VK_NULL_HANDLE);
        ASSERT_TRUE(chosen) << chosen.error().message;
        auto device = vk::Device::create(*instance_, *chosen, false);
        ASSERT_TRUE(device) << device.error().message;
        device_ = std::move(*device);
    }
    // Whoever holds something of the device lets go of it first.
    void TearDown() override {
        device_.reset();
        for (const std::string& message : instance_->messages())
            ADD_FAILURE() << message;
    }

    std::unique_ptr<vk::Instance> instance_;
    std::unique_ptr<vk::Device> device_;
};

}  // namespace onggi::golden
