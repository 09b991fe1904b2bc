// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>

#ifdef __SSE__
#include <xmmintrin.h>
#endif

// Such a function and all that it calls are compiled into one, also for wide registers' instructions, which
// need fewer copies. Both do the same operations in the same order, so they give the same bits; sanitizers
// start too late for the linker's choice between the two.
#if defined(__x86_64__) && defined(__GLIBC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__) && \
    !defined(__SANITIZE_THREAD__)
#define PSICARVE_WHOLE_FOR_WIDE_REGISTERS __attribute__((flatten, target_clones("avx2", "default")))
#else
#define PSICARVE_WHOLE_FOR_WIDE_REGISTERS
#endif

/// Four numbers at a time, as the smallest vectors of the processor hold.
namespace psicarve::tool::dilation {

inline constexpr std::size_t kQuad = 4;

using Quad = float __attribute__((vector_size(16)));
using QuadMask = std::int32_t __attribute__((vector_size(16)));

inline Quad quad_at(const float* from) noexcept {
    Quad quad;
    std::memcpy(&quad, from, sizeof quad);
    return quad;
}
inline QuadMask mask_at(const std::int32_t* from) noexcept {
    QuadMask mask;
    std::memcpy(&mask, from, sizeof mask);
    return mask;
}
inline Quad all_of(float value) noexcept {
    return Quad{value, value, value, value};
}
inline Quad root(const Quad& value) noexcept {
#ifdef __SSE__
    return _mm_sqrt_ps(value);
#else
    return Quad{std::sqrt(value[0]), std::sqrt(value[1]), std::sqrt(value[2]), std::sqrt(value[3])};
#endif
}
inline Quad larger(const Quad& a, const Quad& b) noexcept {
#ifdef __SSE__
    return _mm_max_ps(a, b);
#else
    return a > b ? a : b;
#endif
}
inline Quad smaller(const Quad& a, const Quad& b) noexcept {
#ifdef __SSE__
    return _mm_min_ps(a, b);
#else
    return a < b ? a : b;
#endif
}
/// The absolute value.
inline Quad size_of(const Quad& value) noexcept {
    return larger(value, -value);
}
/// Bit i: the ith is negative (or -0).
inline unsigned negative_bits(const Quad& value) noexcept {
#ifdef __SSE__
    return static_cast<unsigned>(_mm_movemask_ps(value));
#else
    unsigned bits = 0;
    for (unsigned i = 0; i < kQuad; ++i) bits |= std::signbit(value[i]) ? 1U << i : 0U;
    return bits;
#endif
}

}  // namespace psicarve::tool::dilation
