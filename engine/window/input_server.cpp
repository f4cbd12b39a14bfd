#include "engine/window/input_server.h"

#include <xcb/xcb.h>
#include <xcb/xinput.h>

namespace onggi::window {

std::unique_ptr<InputServer> InputServer::connect() {
    std::unique_ptr<InputServer> self(new InputServer(xcb_connect(nullptr, nullptr)));
    xcb_connection_t* server = self->connection_;
    if (xcb_connection_has_error(server) != 0) return nullptr;
    const xcb_query_extension_reply_t* extension = xcb_get_extension_data(server, &xcb_input_id);
    if (extension == nullptr || extension->present == 0) return nullptr;
    self->extension_ = extension->major_opcode;
    const Answer<xcb_input_xi_query_version_reply_t> version(
        xcb_input_xi_query_version_reply(server, xcb_input_xi_query_version(server, 2, 2), nullptr));
    if (!version || version->major_version < 2) return nullptr;
    if (version->major_version == 2 && version->minor_version < 2) return nullptr;
    return self;
}

InputServer::~InputServer() {
    xcb_disconnect(connection_);
}

bool InputServer::select(std::uint32_t window, std::uint16_t device, std::uint32_t mask) {
    struct {
        xcb_input_event_mask_t head;
        std::uint32_t events;
    } const wanted{{.deviceid = device, .mask_len = 1}, mask};
    const auto asked = xcb_input_xi_select_events_checked(connection_, window, 1, &wanted.head);
    const Answer<xcb_generic_error_t> refused(xcb_request_check(connection_, asked));
    return refused == nullptr;
}

InputServer::Answer<xcb_ge_generic_event_t> InputServer::next_event() {
    while (xcb_generic_event_t* event = xcb_poll_for_event(connection_)) {
        Answer<xcb_ge_generic_event_t> generic(reinterpret_cast<xcb_ge_generic_event_t*>(event));
        if (generic->response_type == XCB_GE_GENERIC && generic->extension == extension_) return generic;
    }
    return nullptr;
}

}  // namespace onggi::window
