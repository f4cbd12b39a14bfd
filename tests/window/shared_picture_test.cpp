// A picture in memory shared with a real X server. Runs under with_display.sh.
#include "engine/window/shared_picture.h"

#include <gtest/gtest.h>
#include <xcb/xcb.h>

#include <array>
#include <cstdlib>
#include <cstring>
#include <memory>

#include "engine/window/input_server.h"

namespace onggi::window {
namespace {

constexpr std::uint16_t kWidth = 64;
constexpr std::uint16_t kHeight = 48;

class AWindowsMemory : public testing::Test {
  protected:
    void SetUp() override {
        server_ = xcb_connect(nullptr, nullptr);
        ASSERT_EQ(xcb_connection_has_error(server_), 0) << "run by with_display.sh, which brings a display";
        window_ = open_window(0, kWidth);
        picture_ = SharedPicture::of(window_);
        ASSERT_NE(picture_, nullptr);
        auto lent = picture_->lend(std::size_t{4} * kRowPx * kHeight);
        ASSERT_TRUE(lent) << lent.error().message;
        memory_ = *lent;
    }
    void TearDown() override {
        picture_.reset();
        xcb_disconnect(server_);
    }
    std::uint32_t open_window(std::int16_t x, std::uint16_t width) {
        const xcb_screen_t* screen = xcb_setup_roots_iterator(xcb_get_setup(server_)).data;
        const std::uint32_t window = xcb_generate_id(server_);
        const std::array<std::uint32_t, 2> values{0, 1};  // black, and without a window manager
        xcb_create_window(server_, XCB_COPY_FROM_PARENT, window, screen->root, x, 0, width, kHeight, 0,
                          XCB_WINDOW_CLASS_INPUT_OUTPUT, screen->root_visual,
                          XCB_CW_BACK_PIXEL | XCB_CW_OVERRIDE_REDIRECT, values.data());
        xcb_map_window(server_, window);
        sync();
        return window;
    }
    void sync() { std::free(xcb_get_input_focus_reply(server_, xcb_get_input_focus(server_), nullptr)); }
    void fill(std::uint32_t colour) {
        for (std::size_t at = 0; at < memory_.size(); at += sizeof colour)
            std::memcpy(&memory_[at], &colour, sizeof colour);
    }
    // Shows the picture, and waits until the server has read it.
    void show(std::span<const VkRect2D> changed) {
        ASSERT_TRUE(picture_->wait_until_read());
        picture_->show({kWidth, kHeight}, kRowPx, changed);
        ASSERT_TRUE(picture_->wait_until_read());
    }
    // The window's pixel on the screen: red, green and blue.
    std::uint32_t pixel(std::int16_t x, std::int16_t y) {
        const InputServer::Answer<xcb_get_image_reply_t> image(xcb_get_image_reply(
            server_, xcb_get_image(server_, XCB_IMAGE_FORMAT_Z_PIXMAP, window_, x, y, 1, 1, ~0U), nullptr));
        std::uint32_t found = ~0U;
        if (image) std::memcpy(&found, xcb_get_image_data(image.get()), sizeof found);
        return found & 0xffffffU;
    }

    static constexpr std::uint32_t kRowPx = kWidth + 16;
    xcb_connection_t* server_ = nullptr;
    std::uint32_t window_ = 0;
    std::unique_ptr<SharedPicture> picture_;
    std::span<std::byte> memory_;
};

TEST_F(AWindowsMemory, IsShownWholeAtFirstAndThenByItsChanges) {
    fill(0xff336699);
    show({});
    EXPECT_EQ(pixel(0, 0), 0x336699U);
    EXPECT_EQ(pixel(kWidth - 1, kHeight - 1), 0x336699U);
    fill(0xffaabbcc);
    constexpr std::array kPart{VkRect2D{{10, 20}, {5, 4}}};
    show(kPart);
    EXPECT_EQ(pixel(10, 20), 0xaabbccU);
    EXPECT_EQ(pixel(14, 23), 0xaabbccU);
    EXPECT_EQ(pixel(15, 20), 0x336699U);
    EXPECT_EQ(pixel(9, 20), 0x336699U);
    show({});
    EXPECT_EQ(pixel(0, 0), 0x336699U) << "nothing changed";
}

TEST_F(AWindowsMemory, IsShownWholeAgainAfterTheWindowWasCovered) {
    fill(0xff336699);
    show({});
    const std::uint32_t cover = open_window(0, kWidth / 2);
    EXPECT_EQ(pixel(kWidth - 1, 0), 0x336699U);
    xcb_destroy_window(server_, cover);
    sync();
    show({});  // takes the event
    show({});
    EXPECT_EQ(pixel(0, 0), 0x336699U);
}

TEST_F(AWindowsMemory, IsLentAnewForAnotherSize) {
    for (const std::size_t rows : {200U, 10U, 48U}) {
        auto lent = picture_->lend(std::size_t{4} * kRowPx * rows);
        ASSERT_TRUE(lent) << lent.error().message;
        EXPECT_GE(lent->size(), std::size_t{4} * kRowPx * rows);
        memory_ = *lent;
        EXPECT_EQ(memory_[0], std::byte{0});
    }
    fill(0xff010203);
    show({});
    EXPECT_EQ(pixel(3, 3), 0x010203U);
}

TEST_F(AWindowsMemory, GoesOnAfterTheServerRefusedAPicture) {
    constexpr std::array kOutside{VkRect2D{{0, 0}, {kWidth, 4000}}};
    show({});
    show(kOutside);
    fill(0xff445566);
    show({});
    EXPECT_EQ(pixel(5, 5), 0x445566U) << "the whole picture, because a part of it is missing";
}

TEST(WithoutAServer, NoMemoryIsShared) {
    const std::string display = std::getenv("DISPLAY");
    setenv("DISPLAY", ":999", 1);
    EXPECT_EQ(SharedPicture::of(1), nullptr);
    setenv("DISPLAY", display.c_str(), 1);
    EXPECT_EQ(SharedPicture::of(1), nullptr) << "no such window";
}

}  // namespace
}  // namespace onggi::window
