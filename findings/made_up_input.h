// A made-up input device for libinput: this program answers as the kernel and udev would, and writes the
// reports. For the scripts beside it.
#include <errno.h>
#include <libinput.h>
#include <linux/input.h>
#include <poll.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <time.h>
#include <unistd.h>

static const char* kind;  // udev's property, ID_INPUT_...
static uint8_t events[4], keys[KEY_CNT / 8], moves[2], axes[ABS_CNT / 8];
static struct input_absinfo infos[ABS_CNT];
static int ends[2];  // libinput's, ours

static void has(uint8_t* bits, int code) {
    bits[code / 8] |= (uint8_t)(1U << (code % 8));
}
static void has_key(int code) {
    has(events, EV_KEY), has(keys, code);
}
static void has_move(int code) {
    has(events, EV_REL), has(moves, code);
}
static void has_axis(int code, int least, int most, int a_mm) {
    has(events, EV_ABS), has(axes, code);
    infos[code] = (struct input_absinfo){.minimum = least, .maximum = most, .resolution = a_mm};
}

// udev's library, for one device.
#define IT(type, name, value)    \
    type udev_##name(void* it) { \
        return (void)it, value;  \
    }
void* udev_new(void) {
    return &kind;
}
IT(void*, ref, it)
IT(void*, unref, NULL)
IT(void*, device_ref, it)
IT(void*, device_unref, NULL)
IT(void*, device_get_parent, NULL)
IT(int, device_get_is_initialized, 1)
IT(const char*, device_get_syspath, "/sys/devices/virtual/input/input1/event0")
IT(const char*, device_get_sysname, "event0")
IT(const char*, device_get_devnode, "/dev/null")
IT(const char*, device_get_subsystem, NULL)
void* udev_device_new_from_devnum(void* udev, char type, dev_t number) {
    return (void)type, (void)number, udev;
}
void* udev_device_new_from_syspath(void* udev, const char* path) {
    return (void)path, udev;
}
void* udev_device_get_parent_with_subsystem_devtype(void* it, const char* subsystem, const char* type) {
    return (void)it, (void)subsystem, (void)type, NULL;
}
const char* udev_device_get_property_value(void* it, const char* name) {
    (void)it;
    return strcmp(name, "ID_INPUT") == 0 || strcmp(name, kind) == 0 ? "1" : NULL;
}
const char* udev_device_get_sysattr_value(void* it, const char* name) {
    return (void)it, (void)name, NULL;
}

// The kernel's answers to <linux/input.h>.
int ioctl(int file, unsigned long request, ...) {
    va_list rest;
    va_start(rest, request);
    uint8_t* to = va_arg(rest, uint8_t*);
    va_end(rest);
    if (_IOC_TYPE(request) != 'E') return (int)syscall(SYS_ioctl, file, request, to);
    const unsigned number = _IOC_NR(request), size = _IOC_SIZE(request);
    const struct {
        unsigned number, size;
        const void* bytes;
    } known[] = {{0x02, 8, &(struct input_id){BUS_USB, 1, 1, 1}},
                 {0x06, 8, "made up"},
                 {0x20, sizeof events, events},
                 {0x20 + EV_KEY, sizeof keys, keys},
                 {0x20 + EV_REL, sizeof moves, moves},
                 {0x20 + EV_ABS, sizeof axes, axes}};
    if (number == 0x07 || number == 0x08) return errno = ENOENT, -1;  // neither a place nor a serial number
    if (_IOC_DIR(request) == _IOC_WRITE) return 0;
    if (number == 0x0a) {  // no finger is down
        memset(to + 4, 0xff, size - 4);
        return 0;
    }
    memset(to, 0, size);
    if (number == 0x01) to[2] = 1;  // the version
    if (number >= 0x40 && number < 0x40 + ABS_CNT) memcpy(to, &infos[number - 0x40], sizeof infos[0]);
    for (unsigned i = 0; i < sizeof known / sizeof known[0]; ++i) {
        if (known[i].number == number)
            memcpy(to, known[i].bytes, size < known[i].size ? size : known[i].size);
    }
    return 0;
}

static int opened(const char* path, int flags, void* user) {
    return (void)path, (void)flags, (void)user, ends[0];
}
static void closed(int file, void* user) {
    (void)file, (void)user;
}

static struct libinput* begin(void) {
    static const struct libinput_interface files = {opened, closed};
    has(events, EV_SYN);
    if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_NONBLOCK, 0, ends) != 0) exit(2);
    struct libinput* input = libinput_path_create_context(&files, NULL);
    if (libinput_path_add_device(input, "/dev/null") == NULL) exit(2);
    return input;
}

static double now_ms(void) {
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec * 1e3 + (double)now.tv_nsec * 1e-6;
}

static void say(int type, int code, int value) {
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    const struct input_event event = {.input_event_sec = now.tv_sec,
                                      .input_event_usec = now.tv_nsec / 1000,
                                      .type = (uint16_t)type,
                                      .code = (uint16_t)code,
                                      .value = value};
    if (write(ends[1], &event, sizeof event) != sizeof event) exit(2);
}
static void end_of_report(void) {
    say(EV_SYN, SYN_REPORT, 0);
}

// The next event of that type within 300 ms, or none; others are left out.
static struct libinput_event* next(struct libinput* input, enum libinput_event_type type) {
    for (const double until_ms = now_ms() + 300; now_ms() < until_ms;) {
        struct pollfd file = {.fd = libinput_get_fd(input), .events = POLLIN};
        poll(&file, 1, 5);
        libinput_dispatch(input);
        struct libinput_event* event;
        while ((event = libinput_get_event(input)) != NULL) {
            if (libinput_event_get_type(event) == type) return event;
            libinput_event_destroy(event);
        }
    }
    return NULL;
}
