// A window's picture in memory shared with the X server (MIT-SHM 1.2), on a connection of its own. Main
// thread. Protocol: https://www.x.org/releases/X11R7.7/doc/xextproto/shm.html
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>

#include "engine/vk/host_surface.h"

struct xcb_connection_t;

namespace onggi::window {

class SharedPicture final : public vk::HostSurface {
  public:
    // Null if the server in DISPLAY is not on this machine, or this window's pixels are not of 32 bits with
    // blue first.
    static std::unique_ptr<SharedPicture> of(std::uint32_t window);
    ~SharedPicture() override;
    SharedPicture(const SharedPicture&) = delete;
    SharedPicture& operator=(const SharedPicture&) = delete;

    Result<std::span<std::byte>> lend(std::size_t bytes) override;
    Result<void> wait_until_read() override;
    void show(VkExtent2D size, std::uint32_t row_px, std::span<const VkRect2D> changed) override;

  private:
    SharedPicture(xcb_connection_t* connection, std::uint32_t window)
        : connection_(connection),
          window_(window) {}
    [[nodiscard]] bool shares_memory();
    [[nodiscard]] bool takes_our_pixels();
    // Follows one event, and frees it.
    void follow(void* event);
    void put(const VkRect2D& part, VkExtent2D size, std::uint32_t row_px, bool is_last);
    void give_back();

    xcb_connection_t* connection_;
    std::uint32_t window_;
    std::uint32_t context_ = 0;
    std::uint32_t segment_ = 0;
    std::span<std::byte> memory_;
    std::uint8_t depth_ = 0;
    std::uint8_t read_event_ = 0;  // the number of the event that tells that a picture was read
    bool is_being_read_ = false;
    bool lost_pixels_ = true;  // parts of the window were covered, or it is new
};

}  // namespace onggi::window
