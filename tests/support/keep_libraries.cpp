// Linked into every program of the AddressSanitizer build: libraries that are let go stay loaded, so that a
// leak report made at the end still knows whose memory it is. The Vulkan loader drops its driver with the
// instance, and lsan.supp names the driver's libraries.
extern "C" int dlclose(void* /*handle*/) noexcept {
    return 0;
}
