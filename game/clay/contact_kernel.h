// The part of the paper clay's tick that loops over elements: collision, deformation and the sums of the
// stiffness force, eight elements at a time. Both variants agree to the bit. Haptic thread; no allocation, no
// failure. Units: mm.
#pragma once

#include <array>
#include <cstddef>
#include <new>
#include <vector>

namespace onggi::clay {

// Float storage aligned for loads of whole blocks of eight. Allocates outside the tick only.

// A cache line, which is also a multiple of the widest block the kernels load.
constexpr std::size_t kFloatAlignment = 64;

template <typename T>
struct AlignedAllocator {
    using value_type = T;

    AlignedAllocator() = default;
    template <typename U>
    AlignedAllocator(const AlignedAllocator<U>& /*other*/) {}  // NOLINT: std::vector requires this form

    T* allocate(std::size_t count) {
        return static_cast<T*>(::operator new (count * sizeof(T), std::align_val_t{kFloatAlignment}));
    }
    void deallocate(T* memory, std::size_t /*count*/) noexcept {
        ::operator delete (memory, std::align_val_t{kFloatAlignment});
    }
    friend bool operator==(const AlignedAllocator&, const AlignedAllocator&) { return true; }
};

using AlignedFloats = std::vector<float, AlignedAllocator<float>>;

// Element i always uses lane i % kLanes, so the order of every sum is fixed.
constexpr int kLanes = 8;

enum class KernelVariant {
    kPlain,  // for any processor
    kWide,   // AVX2, one register of eight (without fused multiply-add, which would round differently)
};

// The tool's place and the elements it may reach. Heights are relative to the element nearest the tool, so
// that float keeps seven digits of the small differences that matter.
struct ContactQuery {
    float* radii_mm;  // R_i, aligned to whole blocks and padded to the next one
    float* carry_mm;  // rounding errors of R_i, see PaperClay
    int first;        // the elements [first, end) are tested; all of them exist
    int end;
    int nearest;              // index of the element nearest the tool; may lie beyond the clay
    float nearest_offset_mm;  // its height minus the tool's, less than two elements
    float element_height_mm;
    float tool_radius_mm;     // r1
    float reach_mm;           // r3 - r1, the surface of the tool nearest the axis, rounded to float
    float reach_rest_mm;      // rounding error of reach_mm
    float fraction;           // fraction of the depth that Eq. (2) removes
    float minimum_radius_mm;  // R_min
    bool deform;              // true while the wheel turns
};

struct ContactSums {
    std::array<float, kLanes> depth_times_half_width{};  // sum of d1_i rc_i by lane, mm^2
    std::array<float, kLanes> depth_times_height{};      // sum of d1_i (y_i - h1) by lane, mm^2
    int contacts = 0;
    int first_contact = -1;  // inclusive range of the elements in contact; -1 if empty
    int last_contact = -1;
};

// is_supported: whether this processor and its system can run the variant. best_kernel: the fastest one that
// they can.
[[nodiscard]] bool is_supported(KernelVariant variant);
[[nodiscard]] KernelVariant best_kernel();
[[nodiscard]] const char* name(KernelVariant variant);

// Precondition: is_supported(variant).
void find_contacts(KernelVariant variant, const ContactQuery& query, ContactSums& sums) noexcept;

}  // namespace onggi::clay
