// The part of the paper clay's tick that visits elements: collision, deformation and the sums of the
// stiffness force, eight elements at a time. Two variants of one text that agree to the bit; the haptic
// thread calls one of them. No allocation, no failure. Units: mm.
#pragma once

#include <array>
#include <cstddef>
#include <new>
#include <vector>

namespace onggi::clay {

// Floats at addresses that whole blocks of eight can be loaded from. Allocates outside the tick only.

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

// Element i is always handled in lane i % kLanes, so the order of every sum is fixed.
constexpr int kLanes = 8;

enum class KernelVariant {
    kPlain,  // for any processor
    kWide,   // AVX2, one register of eight (without fused multiply-add, which would round differently)
};

// Where the tool is and which elements it may reach. Heights are relative to the element nearest the tool, so
// that float keeps seven digits of the small differences that matter.
struct ContactQuery {
    float* radii_mm;  // R_i, aligned to whole blocks, padded up to the next one
    float* carry_mm;  // see PaperClay
    int first;        // the elements [first, end) are tested, all of them real ones
    int end;
    int nearest;              // index of the element nearest the tool, may lie beyond the clay
    float nearest_offset_mm;  // its height minus the tool's, less than two elements
    float element_height_mm;
    float tool_radius_mm;     // r1
    float reach_mm;           // r3 - r1, the surface of the tool nearest the axis, rounded to float
    float reach_rest_mm;      // what that rounding left over
    float fraction;           // of the depth, taken by Eq. (2)
    float minimum_radius_mm;  // R_min
    bool deform;              // the wheel turns
};

struct ContactSums {
    std::array<float, kLanes> depth_times_half_width{};  // sum of d1_i rc_i by lane, mm^2
    std::array<float, kLanes> depth_times_height{};      // sum of d1_i (y_i - h1) by lane, mm^2
    int contacts = 0;
    int first_contact = -1;  // the elements in contact lie between these two, inclusive; -1: none
    int last_contact = -1;
};

// Whether this processor (and its system) can run the variant; and the fastest it can run.
[[nodiscard]] bool is_supported(KernelVariant variant);
[[nodiscard]] KernelVariant best_kernel();
[[nodiscard]] const char* name(KernelVariant variant);

// Precondition: is_supported(variant).
void find_contacts(KernelVariant variant, const ContactQuery& query, ContactSums& sums) noexcept;

}  // namespace onggi::clay
