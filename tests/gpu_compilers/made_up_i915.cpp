// A made-up graphics processor of Intel's for Mesa's drivers anv and hasvk, which ask the kernel what it has
// before they compile: this program's own drmGetDevices2() and ioctl() come before libdrm's and the C
// library's, and answer as the kernel's i915 would (<drm/i915_drm.h>). ONGGI_MADE_UP_I915: the PCI number of
// the processor, in hexadecimal; unset: there is none. Its file is /dev/zero, whose pages serve as its
// memory. It runs no commands.
#include <i915_drm.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/sysmacros.h>
#include <unistd.h>
#include <xf86drm.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdarg>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <vector>

namespace {

// Six groups of eight units, as both are common.
constexpr std::uint16_t kGroups = 6;
constexpr std::uint16_t kUnits = 8;
constexpr std::uint8_t kAllGroups = (1U << kGroups) - 1U;
constexpr std::uint8_t kAllUnits = (1U << kUnits) - 1U;
constexpr std::uint64_t kMemoryBytes = std::uint64_t{16} << 30U;

std::array<char, 10> path{"/dev/zero"};
std::array<char, 5> driver{"i915"};
std::array<char, 1> nothing{};
std::array<char*, DRM_NODE_MAX> nodes{path.data(), path.data(), path.data()};
drmPciBusInfo bus{.domain = 0, .bus = 0, .dev = 2, .func = 0};

std::uint16_t pci_number() {
    const char* const number = std::getenv("ONGGI_MADE_UP_I915");
    return number == nullptr ? std::uint16_t{0}
                             : static_cast<std::uint16_t>(std::strtoul(number, nullptr, 16));
}

drmDevice* the_device() {
    static drmPciDeviceInfo info{.vendor_id = 0x8086,
                                 .device_id = pci_number(),
                                 .subvendor_id = 0,
                                 .subdevice_id = 0,
                                 .revision_id = 1};
    static drmDevice device{.nodes = nodes.data(),
                            .available_nodes = 1 << DRM_NODE_PRIMARY | 1 << DRM_NODE_RENDER,
                            .bustype = DRM_BUS_PCI,
                            .businfo = {.pci = &bus},
                            .deviceinfo = {.pci = &info}};
    return &device;
}

std::uint32_t new_number() {
    static std::uint32_t last = 0;
    return ++last;
}

int parameter(int which) {
    switch (which) {
        case I915_PARAM_CHIPSET_ID:
            return pci_number();
        case I915_PARAM_HAS_ALIASING_PPGTT:
            return 3;  // an address space of its own for each context, whole
        case I915_PARAM_CMD_PARSER_VERSION:
            return 10;
        case I915_PARAM_MMAP_GTT_VERSION:
            return 4;  // memory is mapped by an offset into the file
        case I915_PARAM_EU_TOTAL:
            return kGroups * kUnits;
        case I915_PARAM_SUBSLICE_TOTAL:
            return kGroups;
        case I915_PARAM_SUBSLICE_MASK:
            return kAllGroups;
        case I915_PARAM_CS_TIMESTAMP_FREQUENCY:
            return 12'000'000;  // Hz
        default:
            return 1;  // yes
    }
}

template <typename Head, typename Rest>
std::vector<std::uint8_t> bytes_of(const Head& head, const Rest& rest) {
    std::vector<std::uint8_t> bytes(sizeof head + sizeof rest);
    std::memcpy(bytes.data(), &head, sizeof head);
    std::memcpy(bytes.data() + sizeof head, &rest, sizeof rest);
    return bytes;
}

// Empty: unknown, as to an older kernel. Heads that end in an array without a size are cleared by hand:
// braces would begin the array.
std::vector<std::uint8_t> answer_to(std::uint64_t query) {
    if (query == DRM_I915_QUERY_TOPOLOGY_INFO) {
        // The masks of the slice, of its groups, and of the units of each group.
        std::array<std::uint8_t, 2 + kGroups> masks{1, kAllGroups};
        std::fill(masks.begin() + 2, masks.end(), kAllUnits);
        drm_i915_query_topology_info head{};
        head.max_slices = 1;
        head.max_subslices = kGroups;
        head.max_eus_per_subslice = kUnits;
        head.subslice_offset = 1;
        head.subslice_stride = 1;
        head.eu_offset = 2;
        head.eu_stride = 1;
        return bytes_of(head, masks);
    }
    if (query == DRM_I915_QUERY_ENGINE_INFO) {
        drm_i915_query_engine_info head;
        std::memset(&head, 0, sizeof head);
        head.num_engines = 1;
        drm_i915_engine_info engine{};
        engine.engine.engine_class = I915_ENGINE_CLASS_RENDER;
        return bytes_of(head, engine);
    }
    if (query == DRM_I915_QUERY_MEMORY_REGIONS) {
        drm_i915_query_memory_regions head;
        std::memset(&head, 0, sizeof head);
        head.num_regions = 1;
        drm_i915_memory_region_info region{};
        region.region.memory_class = I915_MEMORY_CLASS_SYSTEM;
        region.probed_size = region.unallocated_size = kMemoryBytes;
        return bytes_of(head, region);
    }
    return {};
}

// First the length is asked, then the bytes.
void answer(drm_i915_query& query) {
    auto* const items = reinterpret_cast<drm_i915_query_item*>(query.items_ptr);
    for (std::uint32_t i = 0; i < query.num_items; ++i) {
        const std::vector<std::uint8_t> bytes = answer_to(items[i].query_id);
        const auto length = static_cast<std::int32_t>(bytes.size());
        const bool is_wanted = items[i].length >= length && length > 0;
        if (is_wanted) std::memcpy(reinterpret_cast<void*>(items[i].data_ptr), bytes.data(), bytes.size());
        items[i].length = length > 0 ? length : -EINVAL;
    }
}

// Whatever has a number gets a new one; the rest is granted.
void grant(unsigned long request, void* argument) {
    switch (request) {
        case DRM_IOCTL_I915_GETPARAM: {
            const auto* const get = static_cast<drm_i915_getparam*>(argument);
            *get->value = parameter(get->param);
            break;
        }
        case DRM_IOCTL_I915_QUERY:
            answer(*static_cast<drm_i915_query*>(argument));
            break;
        case DRM_IOCTL_GET_CAP:
            static_cast<drm_get_cap*>(argument)->value = 1;
            break;
        case DRM_IOCTL_SYNCOBJ_CREATE:
            static_cast<drm_syncobj_create*>(argument)->handle = new_number();
            break;
        case DRM_IOCTL_I915_GEM_CREATE:
            static_cast<drm_i915_gem_create*>(argument)->handle = new_number();
            break;
        case DRM_IOCTL_I915_GEM_CREATE_EXT:
            static_cast<drm_i915_gem_create_ext*>(argument)->handle = new_number();
            break;
        case DRM_IOCTL_I915_GEM_CONTEXT_CREATE:
        case DRM_IOCTL_I915_GEM_CONTEXT_CREATE_EXT:
            static_cast<drm_i915_gem_context_create*>(argument)->ctx_id = new_number();
            break;
        case DRM_IOCTL_I915_GEM_VM_CREATE:
            static_cast<drm_i915_gem_vm_control*>(argument)->vm_id = new_number();
            break;
        case DRM_IOCTL_I915_GEM_CONTEXT_GETPARAM: {
            auto* const get = static_cast<drm_i915_gem_context_param*>(argument);
            get->value = get->param == I915_CONTEXT_PARAM_GTT_SIZE ? std::uint64_t{1} << 48U : 0;
            break;
        }
        case DRM_IOCTL_I915_GEM_GET_APERTURE: {
            auto* const aperture = static_cast<drm_i915_gem_get_aperture*>(argument);
            aperture->aper_size = aperture->aper_available_size = kMemoryBytes;
            break;
        }
        case DRM_IOCTL_I915_GEM_MMAP_OFFSET:
            static_cast<drm_i915_gem_mmap_offset*>(argument)->offset = 0;
            break;
        default:
            break;
    }
}

bool is_the_device(int file) {
    struct stat status {};
    return fstat(file, &status) == 0 && S_ISCHR(status.st_mode) && status.st_rdev == makedev(1, 5);
}

}  // namespace

extern "C" {

int drmGetDevices2(std::uint32_t, drmDevicePtr devices[], int room) {
    if (pci_number() == 0) return 0;
    if (devices != nullptr && room > 0) devices[0] = the_device();
    return 1;
}
int drmGetDevice2(int, std::uint32_t, drmDevicePtr* device) {
    *device = the_device();
    return 0;
}
int drmGetDevice(int file, drmDevicePtr* device) {
    return drmGetDevice2(file, 0, device);
}
void drmFreeDevices(drmDevicePtr*, int) {}
void drmFreeDevice(drmDevicePtr*) {}

drmVersionPtr drmGetVersion(int) {
    static drmVersion version{.version_major = 1,
                              .version_minor = 6,
                              .version_patchlevel = 0,
                              .name_len = 4,
                              .name = driver.data(),
                              .date_len = 0,
                              .date = nothing.data(),
                              .desc_len = 0,
                              .desc = nothing.data()};
    return &version;
}
void drmFreeVersion(drmVersionPtr) {}

int ioctl(int file, unsigned long request, ...) noexcept {
    va_list rest;
    va_start(rest, request);
    void* const argument = va_arg(rest, void*);
    va_end(rest);
    if (_IOC_TYPE(request) != DRM_IOCTL_BASE || !is_the_device(file))
        return static_cast<int>(::syscall(SYS_ioctl, file, request, argument));
    grant(request, argument);
    return 0;
}

}  // extern "C"
