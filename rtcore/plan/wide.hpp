// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <new>
#include <vector>

#include "rtcore/plan/path.hpp"

// Four axes fit one AVX register; the newest processors have twice as many of those. The same operations in
// the same order, so the same bits, with or without; sanitizers start too late for the linker's choice.
#if defined(__x86_64__) && defined(__GLIBC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__) && \
    !defined(__SANITIZE_THREAD__)
#if __GNUC__ >= 12
#define PSICARVE_FOR_WIDE_REGISTERS __attribute__((target_clones("arch=x86-64-v4", "avx2", "default")))
#else
#define PSICARVE_FOR_WIDE_REGISTERS __attribute__((target_clones("avx2", "default")))
#endif
#else
#define PSICARVE_FOR_WIDE_REGISTERS
#endif
// What such code calls has to become a part of it: by itself it would be code for narrow registers.
#define PSICARVE_INLINE __attribute__((always_inline)) inline

namespace psicarve::plan {

/// One number an axis, in the processor's own vectors. Never passed or returned by value.
/// Aligned alike in code for wide registers and in other code.
using Vec = double __attribute__((vector_size(kAxisCount * sizeof(double)), aligned(16)));
using Mask = std::int64_t __attribute__((vector_size(kAxisCount * sizeof(std::int64_t)), aligned(16)));

/// Containers would forget a Vec's alignment.
struct Four {
    Vec axes;
};

/// Where a Vec never lies across two of the processor's cache lines, which would be two accesses each.
template <typename T>
struct WideAllocator {
    using value_type = T;
    static constexpr std::align_val_t kCacheLineBytes{64};

    WideAllocator() = default;
    template <typename Other>
    explicit WideAllocator(const WideAllocator<Other>& /*other*/) noexcept {}
    T* allocate(std::size_t count) {
        return static_cast<T*>(::operator new(count * sizeof(T), kCacheLineBytes));
    }
    void deallocate(T* memory, std::size_t /*count*/) noexcept { ::operator delete(memory, kCacheLineBytes); }
    friend bool operator==(const WideAllocator& /*one*/, const WideAllocator& /*other*/) noexcept {
        return true;
    }
};
/// Of what consists of whole Vecs.
template <typename T>
using WideVector = std::vector<T, WideAllocator<T>>;

PSICARVE_INLINE void load(const Lanes& lanes, Vec& vec) {
    std::memcpy(&vec, lanes.data(), sizeof vec);
}
PSICARVE_INLINE void store(const Vec& vec, Lanes& lanes) {
    std::memcpy(lanes.data(), &vec, sizeof vec);
}

PSICARVE_INLINE void raise_to(Vec& greatest, const Vec& value) {
    greatest = value > greatest ? value : greatest;
}
PSICARVE_INLINE void lower_to(Vec& least, const Vec& value) {
    least = value < least ? value : least;
}

/// Of the four numbers.
PSICARVE_INLINE double least_of(const Vec& vec) {
    Vec pairs = __builtin_shufflevector(vec, vec, 2, 3, 0, 1);
    lower_to(pairs, vec);
    return pairs[1] < pairs[0] ? pairs[1] : pairs[0];
}
PSICARVE_INLINE double greatest_of(const Vec& vec) {
    Vec pairs = __builtin_shufflevector(vec, vec, 2, 3, 0, 1);
    raise_to(pairs, vec);
    return pairs[1] > pairs[0] ? pairs[1] : pairs[0];
}

}  // namespace psicarve::plan
