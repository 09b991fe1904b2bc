// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/model/large_memory.hpp"

#include <sys/mman.h>

#include <cstddef>
#include <cstdlib>

namespace psicarve::model {
namespace {

constexpr std::size_t kHugePageBytes = std::size_t{1} << 21U;

}  // namespace

void* allocate_large(std::size_t bytes) noexcept {
    if (bytes < 2 * kHugePageBytes) return std::malloc(bytes == 0 ? 1 : bytes);
    const std::size_t whole = (bytes + kHugePageBytes - 1) / kHugePageBytes * kHugePageBytes;
    void* memory = std::aligned_alloc(kHugePageBytes, whole);
    // Only an advice: without huge pages everything works as well, a little slower.
    if (memory != nullptr) static_cast<void>(::madvise(memory, whole, MADV_HUGEPAGE));
    return memory;
}

void free_large(void* memory) noexcept {
    std::free(memory);
}

}  // namespace psicarve::model
