// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "tests/hmi/x11/child_process.hpp"
#include "tests/two_process/core_rig.hpp"

namespace psicarve::test {

/// A screen of its own with a window manager, the operator's window as a program of its own on it, a real
/// core, and a hand on mouse and keyboard. Everything is waited for by what it shows, nothing by time.
class X11Rig : public two_process::CoreRig {
protected:
    void SetUp() override;

    void open_window(std::vector<std::string> arguments = {}, std::vector<std::string> environment = {});
    /// The window's own answer.
    std::string ask(const std::string& question) const;
    ::testing::AssertionResult says(const std::string& question, const std::string& part);
    /// The state's word and what stands below it.
    std::string pill() const { return ask("text state_pill"); }

    /// Waits until it can be pressed and stands still, moves the mouse there and presses; the window says
    /// what the mouse has met. Again where that was no button at all; a failure where it was another.
    ::testing::AssertionResult click(const std::string& name) { return use_mouse(name, "1"); }
    ::testing::AssertionResult turn_wheel_down(const std::string& name) { return use_mouse(name, "5"); }
    /// The left button goes down on it and stays down.
    ::testing::AssertionResult hold_mouse_on(const std::string& name);
    void resize_window(int width, int height);
    void let_go_of_mouse() { xdotool({"mouseup", "1"}); }
    void press(const std::vector<std::string>& keys);
    void key_down(const std::string& key) { xdotool({"keydown", key}); }
    void key_up(const std::string& key) { xdotool({"keyup", key}); }
    void type(const std::string& text);
    /// Into a field, instead of what stands there.
    ::testing::AssertionResult fill_in(const std::string& name, const std::string& text);
    /// In the file dialog of that title; once the name stands there whole, Return.
    ::testing::AssertionResult choose_file(const std::string& title, const std::string& path);
    /// The whole screen, into the build folder, to be looked at.
    void take_picture(const std::string& name);

    std::string screen_size_ = "1366x768";
    std::unique_ptr<ChildProcess> window_;

private:
    ::testing::AssertionResult use_mouse(const std::string& name, const std::string& mouse_button,
                                         const std::string& how = "click");
    std::string touch(const std::string& name, const std::string& mouse_button, const std::string& how);
    void xdotool(std::vector<std::string> words);

    std::unique_ptr<ChildProcess> screen_;
    std::unique_ptr<ChildProcess> manager_;
    std::vector<std::string> environment_;
};

}  // namespace psicarve::test
