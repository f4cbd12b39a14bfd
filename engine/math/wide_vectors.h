// A mark for functions that are compiled twice: for any processor, and in wider vectors for those that have
// AVX2. Without fused multiply-add, so that both compute the same bits.
#pragma once

// The loader selects the variant once. The function must be local to its file, under a name and parameters of
// its own in the whole program: clang gives the selector external linkage. Under a sanitizer there is only
// the first variant, because the loader selects before a sanitizer has started.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define ONGGI_WIDE_VECTORS
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define ONGGI_WIDE_VECTORS
#endif
#endif
#if !defined(ONGGI_WIDE_VECTORS) && defined(__x86_64__)
#define ONGGI_WIDE_VECTORS __attribute__((target_clones("default", "avx2")))
#elif !defined(ONGGI_WIDE_VECTORS)
#define ONGGI_WIDE_VECTORS
#endif
