#include "engine/window/shared_picture.h"

#include <sys/mman.h>
#include <unistd.h>
#include <xcb/shm.h>
#include <xcb/xcb.h>

#include <array>
#include <cerrno>
#include <system_error>

#include "engine/window/input_server.h"

namespace onggi::window {
namespace {

template <typename T>
using Answer = InputServer::Answer<T>;

const xcb_visualtype_t* visual_of(xcb_connection_t* server, xcb_visualid_t wanted) {
    for (auto screen = xcb_setup_roots_iterator(xcb_get_setup(server)); screen.rem > 0;
         xcb_screen_next(&screen)) {
        for (auto depth = xcb_screen_allowed_depths_iterator(screen.data); depth.rem > 0;
             xcb_depth_next(&depth)) {
            for (auto visual = xcb_depth_visuals_iterator(depth.data); visual.rem > 0;
                 xcb_visualtype_next(&visual)) {
                if (visual.data->visual_id == wanted) return visual.data;
            }
        }
    }
    return nullptr;
}

// Whether pixels of that depth take 32 bits.
bool is_of_32_bits(xcb_connection_t* server, std::uint8_t depth) {
    for (auto format = xcb_setup_pixmap_formats_iterator(xcb_get_setup(server)); format.rem > 0;
         xcb_format_next(&format)) {
        if (format.data->depth == depth) return format.data->bits_per_pixel == 32;
    }
    return false;
}

}  // namespace

std::unique_ptr<SharedPicture> SharedPicture::of(std::uint32_t window) {
    std::unique_ptr<SharedPicture> self(new SharedPicture(xcb_connect(nullptr, nullptr), window));
    if (xcb_connection_has_error(self->connection_) != 0) return nullptr;
    if (!self->takes_our_pixels() || !self->shares_memory()) return nullptr;
    self->context_ = xcb_generate_id(self->connection_);
    xcb_create_gc(self->connection_, self->context_, window, 0, nullptr);
    constexpr std::uint32_t kWanted = XCB_EVENT_MASK_EXPOSURE;
    xcb_change_window_attributes(self->connection_, window, XCB_CW_EVENT_MASK, &kWanted);
    // A server on another machine ends the connection as soon as it is sent a file.
    const auto page = static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
    if (!self->lend(page)) return nullptr;
    return self;
}

SharedPicture::~SharedPicture() {
    give_back();
    xcb_disconnect(connection_);
}

bool SharedPicture::shares_memory() {
    const xcb_query_extension_reply_t* extension = xcb_get_extension_data(connection_, &xcb_shm_id);
    if (extension == nullptr || extension->present == 0) return false;
    read_event_ = static_cast<std::uint8_t>(extension->first_event + XCB_SHM_COMPLETION);
    const Answer<xcb_shm_query_version_reply_t> version(
        xcb_shm_query_version_reply(connection_, xcb_shm_query_version(connection_), nullptr));
    // Version 1.2 takes memory as a file, which needs no name and cannot be left behind.
    return version && (version->major_version > 1 || version->minor_version >= 2);
}

bool SharedPicture::takes_our_pixels() {
    const Answer<xcb_get_geometry_reply_t> geometry(
        xcb_get_geometry_reply(connection_, xcb_get_geometry(connection_, window_), nullptr));
    const Answer<xcb_get_window_attributes_reply_t> attributes(xcb_get_window_attributes_reply(
        connection_, xcb_get_window_attributes(connection_, window_), nullptr));
    if (!geometry || !attributes) return false;
    const xcb_visualtype_t* visual = visual_of(connection_, attributes->visual);
    depth_ = geometry->depth;
    return visual != nullptr && visual->_class == XCB_VISUAL_CLASS_TRUE_COLOR &&
           visual->red_mask == 0xff0000 && visual->green_mask == 0xff00 && visual->blue_mask == 0xff &&
           is_of_32_bits(connection_, depth_) &&
           xcb_get_setup(connection_)->image_byte_order == XCB_IMAGE_ORDER_LSB_FIRST;
}

void SharedPicture::give_back() {
    if (memory_.empty()) return;
    xcb_shm_detach(connection_, segment_);
    munmap(memory_.data(), memory_.size());
    memory_ = {};
}

Result<std::span<std::byte>> SharedPicture::lend(std::size_t bytes) {
    give_back();
    const auto page = static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
    const std::size_t size = (bytes + page - 1) / page * page;
    const int file = memfd_create("onggi picture", MFD_CLOEXEC);
    void* const mapped = file < 0 || ftruncate(file, static_cast<off_t>(size)) != 0
                             ? MAP_FAILED
                             : mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
    if (mapped == MAP_FAILED) {
        const int error = errno;
        if (file >= 0) close(file);
        return system_lacks("window: memory for its picture was refused: " +
                            std::system_category().message(error));
    }
    memory_ = {static_cast<std::byte*>(mapped), size};
    segment_ = xcb_generate_id(connection_);
    constexpr std::uint8_t kReadOnly = 1;
    // This call closes the file.
    const auto asked = xcb_shm_attach_fd_checked(connection_, segment_, file, kReadOnly);
    const Answer<xcb_generic_error_t> refused(xcb_request_check(connection_, asked));
    if (refused || xcb_connection_has_error(connection_) != 0) {
        munmap(memory_.data(), memory_.size());
        memory_ = {};
        return system_lacks("window: expected an X server that shares memory, found one that refused it");
    }
    is_being_read_ = false;
    lost_pixels_ = true;
    return memory_;
}

void SharedPicture::follow(void* event) {
    const Answer<xcb_generic_event_t> taken(static_cast<xcb_generic_event_t*>(event));
    constexpr std::uint8_t kSent = 0x80;  // set in events that a client sent
    const auto kind = static_cast<std::uint8_t>(taken->response_type & ~kSent);
    if (kind == read_event_ || kind == 0) is_being_read_ = false;  // 0: the server refused the picture
    if (kind == XCB_EXPOSE || kind == 0) lost_pixels_ = true;
}

Result<void> SharedPicture::wait_until_read() {
    while (is_being_read_) {
        xcb_generic_event_t* const event = xcb_wait_for_event(connection_);
        if (event == nullptr) return failed("window: the connection to the X server has ended");
        follow(event);
    }
    while (xcb_generic_event_t* const event = xcb_poll_for_event(connection_))
        follow(event);
    return {};
}

void SharedPicture::put(const VkRect2D& part, VkExtent2D size, std::uint32_t row_px, bool is_last) {
    const auto x = static_cast<std::uint16_t>(part.offset.x);
    const auto y = static_cast<std::uint16_t>(part.offset.y);
    xcb_shm_put_image(
        connection_, window_, context_, static_cast<std::uint16_t>(row_px),
        static_cast<std::uint16_t>(size.height), x, y, static_cast<std::uint16_t>(part.extent.width),
        static_cast<std::uint16_t>(part.extent.height), static_cast<std::int16_t>(x),
        static_cast<std::int16_t>(y), depth_, XCB_IMAGE_FORMAT_Z_PIXMAP, is_last ? 1 : 0, segment_, 0);
}

void SharedPicture::show(VkExtent2D size, std::uint32_t row_px, std::span<const VkRect2D> changed) {
    const std::array whole{VkRect2D{{0, 0}, size}};
    const std::span<const VkRect2D> parts = std::exchange(lost_pixels_, false) ? whole : changed;
    for (const VkRect2D& part : parts)
        put(part, size, row_px, &part == &parts.back());
    is_being_read_ = !parts.empty();
    xcb_flush(connection_);
}

}  // namespace onggi::window
