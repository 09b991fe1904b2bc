// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/guard/guard_page.hpp"

#include <sys/mman.h>

#include <cerrno>
#include <new>
#include <system_error>
#include <utility>

namespace psicarve::guard {

Result<GuardPage> GuardPage::make() {
    void* const page =
        mmap(nullptr, sizeof(Words), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (page == MAP_FAILED) {
        return Error{ErrorCode::no_core,
                     "no memory to share with the guard: " + std::generic_category().message(errno)};
    }
    return GuardPage{new (page) Words{}};
}

GuardPage::GuardPage(GuardPage&& other) noexcept : words_(std::exchange(other.words_, nullptr)) {}

GuardPage::~GuardPage() {
    if (words_ != nullptr) munmap(words_, sizeof(Words));
}

}  // namespace psicarve::guard
