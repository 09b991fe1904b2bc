// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "tests/hmi/ui/pages_rig.hpp"

class QAction;
class QDialog;

namespace psicarve::ui::test {

/// A hand on mouse and keyboard of a window that is in front.
class HandsRig : public PagesRig {
protected:
    void open_in_front();
    void bring_to_front();
    /// Where the focus is.
    void press_key(Qt::Key key, Qt::KeyboardModifiers with = Qt::NoModifier);
    /// Shows its menu and clicks it there; says why it could not.
    ::testing::AssertionResult choose_entry(const char* name);
    QAction& entry(const char* name);
    using Answer = std::function<void(QDialog&)>;
    /// Does what opens dialogs, one after the other, and there an answer each; false when fewer opened.
    bool answered(const std::function<void()>& open, const std::vector<Answer>& answers);
    /// Writes a path into each file dialog that `open` opens; "" closes it.
    bool named_files(const std::function<void()>& open, const std::vector<std::string>& paths);
    bool named_file(const std::function<void()>& open, const std::string& path) {
        return named_files(open, {path});
    }
};

}  // namespace psicarve::ui::test
