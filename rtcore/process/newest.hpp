// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <memory>
#include <utility>

namespace psicarve::rtcore {

/// Holds one thing until a reader takes it; a newer one replaces an older. Any thread, no locks. Not for the
/// tick.
template <typename T>
class Newest {
public:
    Newest() = default;
    Newest(const Newest&) = delete;
    Newest& operator=(const Newest&) = delete;
    ~Newest() { take(); }

    /// False: it replaced one that waited, and the reader that was told of that one takes this instead.
    bool put(T thing) {
        const std::unique_ptr<T> before{waiting_.exchange(new T{std::move(thing)})};
        return before == nullptr;
    }
    /// Null: nothing waits.
    std::unique_ptr<T> take() { return std::unique_ptr<T>{waiting_.exchange(nullptr)}; }

private:
    std::atomic<T*> waiting_{nullptr};
};

}  // namespace psicarve::rtcore
