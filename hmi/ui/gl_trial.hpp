// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace psicarve::ui {

/// Remembers that OpenGL is being tried, so that a driver that takes the program down with it is not asked
/// again: a file with the program's number, there from before the first call to after the first frames.
class GlTrial {
public:
    /// `folder`: where the program keeps its state; empty: nothing is remembered.
    explicit GlTrial(const std::string& folder);

    /// A program that tried it is no more and did not get through.
    bool has_crashed_before() const;
    void begin() const;
    /// It went well, or is not tried any more.
    void end() const;

private:
    std::string path_;
};

}  // namespace psicarve::ui
