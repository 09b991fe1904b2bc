// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <future>
#include <optional>
#include <string>

#include "hmi/session/background_queue.hpp"

namespace psicarve::ui {

/// Remembers that OpenGL is being tried, so that a driver that takes the program down with it is not asked
/// again: a file with the program's number, there from before the first call to after the first frames. A
/// thread reads and writes it, whose disk may take its time. One thread, the owner's.
class GlTrial {
public:
    /// `folder`: where the program keeps its state; empty: nothing is remembered.
    explicit GlTrial(const std::string& folder);
    /// What was begun or ended is so on the disk, however long it takes.
    ~GlTrial();
    GlTrial(const GlTrial&) = delete;
    GlTrial& operator=(const GlTrial&) = delete;

    /// A program that tried it is no more and did not get through. Nothing: not known yet, after this limit.
    std::optional<bool> has_crashed_before(std::chrono::milliseconds limit);
    /// True once it is remembered; else OpenGL is not to be tried: it could not be, or was not within the
    /// limit and is not to be any more.
    bool begin(std::chrono::milliseconds limit);
    /// It went well, or is not tried any more.
    void end();

private:
    std::string path_;
    std::shared_future<bool> crash_;  ///< once it was asked for
    session::BackgroundQueue queue_;
};

}  // namespace psicarve::ui
