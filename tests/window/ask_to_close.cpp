// Asks a window to close, as a window manager does for its cross and for Alt+F4 (ICCCM 4.2.8.1): ask_to_close
// WINDOW. Exit code 2 for bad usage, 3 without a display.
#include <X11/Xlib.h>

#include <cstdlib>

int main(int argc, char** argv) {
    const Window window = argc == 2 ? std::strtoul(argv[1], nullptr, 0) : 0;
    if (window == 0) return 2;
    Display* const display = XOpenDisplay(nullptr);
    if (display == nullptr) return 3;
    XEvent event{};
    event.xclient.type = ClientMessage;
    event.xclient.window = window;
    event.xclient.message_type = XInternAtom(display, "WM_PROTOCOLS", False);
    event.xclient.format = 32;
    event.xclient.data.l[0] = static_cast<long>(XInternAtom(display, "WM_DELETE_WINDOW", False));
    event.xclient.data.l[1] = CurrentTime;
    XSendEvent(display, window, False, NoEventMask, &event);
    XCloseDisplay(display);
    return 0;
}
