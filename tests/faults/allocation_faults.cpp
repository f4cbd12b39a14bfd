#include "tests/faults/allocation_faults.h"

#include <array>
#include <atomic>
#include <cerrno>
#include <cstddef>

// The C library's own functions under the names that are not interposed; dlsym() would itself allocate.
// NOLINTBEGIN: names are the library's
extern "C" {
void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* memory, std::size_t size);
void* __libc_memalign(std::size_t alignment, std::size_t size);
}
// NOLINTEND

namespace onggi::faults {
namespace {

// No object with a constructor: the first allocation comes before main().
std::atomic<bool> counts = false;
std::atomic<Shortage> shortage_now = Shortage::kNone;
std::atomic<long> first = 0;
std::atomic<long> count = 0;

bool is_refused() {
    if (!counts) return false;
    const long number = ++count;
    const Shortage shortage = shortage_now;
    return (shortage == Shortage::kOnce && number == first) ||
           (shortage == Shortage::kForGood && number >= first);
}

template <typename Allocate>
void* unless_refused(Allocate&& allocate) {
    if (!is_refused()) return allocate();
    errno = ENOMEM;
    return nullptr;
}

}  // namespace

const char* name_of(Shortage shortage) {
    constexpr std::array<const char*, 3> kNames{"counted", "once", "for good"};
    return kNames[static_cast<std::size_t>(shortage)];
}

void run_short(Shortage shortage, long at) {
    shortage_now = shortage;
    first = at;
    count = 0;
    counts = true;
}
void end_shortage() {
    counts = false;
}
long allocations() {
    return count;
}

}  // namespace onggi::faults

// Interposes the C library's functions and forwards to them. Its free() takes back what they return.
extern "C" {
// NOLINTBEGIN: names and signatures are the library's
using onggi::faults::unless_refused;

void* malloc(size_t size) {
    return unless_refused([&] { return __libc_malloc(size); });
}
void* calloc(size_t count, size_t size) {
    return unless_refused([&] { return __libc_calloc(count, size); });
}
void* realloc(void* memory, size_t size) {
    return unless_refused([&] { return __libc_realloc(memory, size); });
}
void* memalign(size_t alignment, size_t size) {
    return unless_refused([&] { return __libc_memalign(alignment, size); });
}
void* aligned_alloc(size_t alignment, size_t size) {
    return memalign(alignment, size);
}
int posix_memalign(void** memory, size_t alignment, size_t size) {
    void* const found = memalign(alignment, size);
    if (found == nullptr) return ENOMEM;
    *memory = found;
    return 0;
}
// NOLINTEND
}
