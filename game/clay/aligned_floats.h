// Floats at addresses that whole blocks of eight can be loaded from. Allocates outside the tick only.
#pragma once

#include <cstddef>
#include <new>
#include <vector>

namespace onggi::clay {

// A cache line, which is also a multiple of the widest block the kernels load.
constexpr std::size_t kFloatAlignment = 64;

template <typename T>
struct AlignedAllocator {
    using value_type = T;

    AlignedAllocator() = default;
    template <typename U>
    AlignedAllocator(const AlignedAllocator<U>& /*other*/) {}  // NOLINT: the form std::vector asks for

    T* allocate(std::size_t count) {
        return static_cast<T*>(::operator new (count * sizeof(T), std::align_val_t{kFloatAlignment}));
    }
    void deallocate(T* memory, std::size_t /*count*/) noexcept {
        ::operator delete (memory, std::align_val_t{kFloatAlignment});
    }
    friend bool operator==(const AlignedAllocator&, const AlignedAllocator&) { return true; }
};

using AlignedFloats = std::vector<float, AlignedAllocator<float>>;

}  // namespace onggi::clay
