// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>
#include <new>
#include <utility>

namespace psicarve::model {

/// Memory for arrays of millions of elements, in huge pages where the system has them: at a million facets
/// the first touch of small pages costs as much as reading the file. Null when there is none.
void* allocate_large(std::size_t bytes) noexcept;
void free_large(void* memory) noexcept;

/// For large arrays of trivial types; leaves new elements unset, since each is written exactly once.
template <typename T>
class UnsetAllocator {
public:
    using value_type = T;
    UnsetAllocator() noexcept = default;
    template <typename U>
    UnsetAllocator(const UnsetAllocator<U>&) noexcept {}  // NOLINT(google-explicit-constructor)

    T* allocate(std::size_t count) {
        if (count > static_cast<std::size_t>(-1) / 2 / sizeof(T)) throw std::bad_alloc();
        void* memory = allocate_large(count * sizeof(T));
        if (memory == nullptr) throw std::bad_alloc();
        return static_cast<T*>(memory);
    }
    void deallocate(T* memory, std::size_t /*count*/) noexcept { free_large(memory); }

    template <typename U, typename... Args>
    void construct(U* place, Args&&... args) {
        if constexpr (sizeof...(Args) == 0) {
            ::new (static_cast<void*>(place)) U;
        } else {
            ::new (static_cast<void*>(place)) U(std::forward<Args>(args)...);
        }
    }

    friend bool operator==(const UnsetAllocator&, const UnsetAllocator&) noexcept { return true; }
};

}  // namespace psicarve::model
