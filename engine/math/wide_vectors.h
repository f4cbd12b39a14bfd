// For functions compiled twice: for any processor, and with wider vectors where available. Without fused
// multiply-add, so that both compute the same bits. Any thread.
#pragma once

#if defined(__x86_64__)
#define ONGGI_WIDE_VECTORS [[gnu::target("avx2")]]
#else
#define ONGGI_WIDE_VECTORS
#endif

namespace onggi {

// Whether this processor can run functions marked ONGGI_WIDE_VECTORS.
inline bool has_wide_vectors() {
#if defined(__x86_64__)
    return __builtin_cpu_supports("avx2") != 0;
#else
    return false;
#endif
}

template <typename Function>
[[nodiscard]] Function* best_of(Function* plain, Function* wide) {
    return has_wide_vectors() ? wide : plain;
}

}  // namespace onggi
