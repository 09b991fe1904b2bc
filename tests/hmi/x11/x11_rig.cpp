// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/hmi/x11/x11_rig.hpp"
#include "tests/places.hpp"

#include <sys/stat.h>

#include <chrono>
#include <csignal>
#include <cstdio>

namespace psicarve::test {

using std::chrono::milliseconds;

void X11Rig::SetUp() {
    std::signal(SIGPIPE, SIG_IGN);  // a window that is gone answers nothing
    screen_ = std::make_unique<ChildProcess>(
        std::vector<std::string>{"Xvfb", "-displayfd", "1", "-screen", "0", screen_size_ + "x24", "-nolisten",
                                 "tcp", "-noreset"},
        std::vector<std::string>{}, file("screen.log"));
    const std::string number = screen_->read_line();
    ASSERT_FALSE(number.empty()) << two_process::text_of(file("screen.log"));
    environment_ = {"DISPLAY=:" + number, "QT_QPA_PLATFORM=xcb", "XDG_RUNTIME_DIR=" + file(""),
                    "XDG_CONFIG_HOME=" + file(""), "HOME=" + file(""), "LC_ALL=C.UTF-8",
                    // No card: the processor draws, the same on every machine.
                    "LIBGL_ALWAYS_SOFTWARE=1"};
    manager_ = std::make_unique<ChildProcess>(std::vector<std::string>{"openbox"}, environment_,
                                              file("manager.log"));
    // A window that is there before its manager is never given the focus.
    ASSERT_TRUE(eventually([this] {
        return run_to_end({"xdotool", "get_num_desktops"}, environment_) == 0;
    })) << two_process::text_of(file("manager.log"));
}

void X11Rig::open_window(std::vector<std::string> arguments, std::vector<std::string> environment) {
    std::vector<std::string> words{in_build("tests/watched_hmi"), "--segment", segment_name_};
    words.insert(words.end(), arguments.begin(), arguments.end());
    environment.insert(environment.end(), environment_.begin(), environment_.end());
    window_ = std::make_unique<ChildProcess>(words, environment, file("window.log"));
    ASSERT_TRUE(says("where window", " ready")) << two_process::text_of(file("window.log"));
}

std::string X11Rig::ask(const std::string& question) const {
    window_->write_line(question);
    return window_->read_line();
}

::testing::AssertionResult X11Rig::says(const std::string& question, const std::string& part) {
    std::string answer;
    const bool has_come = eventually([&] {
        answer = ask(question);
        return answer.find(part) != std::string::npos;
    });
    if (has_come) return ::testing::AssertionSuccess();
    take_picture("failed");
    return ::testing::AssertionFailure()
           << question << ": " << answer << ", not " << part << "; state " << pill();
}

/// Aims and presses once; what the mouse has met.
std::string X11Rig::touch(const std::string& name, const std::string& mouse_button, const std::string& how) {
    constexpr milliseconds kForOneTouch{10'000};
    std::string answer;
    std::string last_place;
    // It may move while the mouse does: bars come and go.
    const bool is_aimed = eventually([&] {
        int x = 0;
        int y = 0;
        answer = ask("aim " + name);
        if (std::sscanf(answer.c_str(), "%d %d", &x, &y) != 2 || !answer.ends_with(" ready")) return false;
        if (answer == last_place) return true;
        last_place = answer;
        xdotool({"mousemove", std::to_string(x), std::to_string(y)});
        return false;
    });
    if (!is_aimed) return "cannot be pressed: " + answer;
    xdotool({how, mouse_button});
    const std::string last = mouse_button == "5" ? "wheel" : how == "mousedown" ? "press" : "release";
    eventually([&] { return (answer = ask("met " + last)) != "none"; }, kForOneTouch);
    if (answer == "it" && last == "release") answer = ask("met press");
    // It was the last thing that this window has heard.
    return answer.empty() ? "it" : answer;
}

::testing::AssertionResult X11Rig::use_mouse(const std::string& name, const std::string& mouse_button,
                                             const std::string& how) {
    std::string met;
    const bool has_met = eventually([&] {
        met = touch(name, mouse_button, how);
        if (met != "it") std::printf("the mouse meant %s and has met: %s\n", name.c_str(), met.c_str());
        // What the hand did to another button cannot be taken back.
        return met == "it" || met.starts_with("other button") || met.starts_with("cannot");
    });
    if (has_met && met == "it") return ::testing::AssertionSuccess();
    take_picture("failed");
    return ::testing::AssertionFailure() << name << ": " << met << "; state " << pill();
}

::testing::AssertionResult X11Rig::hold_mouse_on(const std::string& name) {
    return use_mouse(name, "1", "mousedown");
}

::testing::AssertionResult X11Rig::fill_in(const std::string& name, const std::string& text) {
    auto clicked = click(name);
    if (!clicked) return clicked;
    press({"ctrl+a"});
    type(text);
    press({"Tab"});
    return ::testing::AssertionSuccess();
}

::testing::AssertionResult X11Rig::choose_file(const std::string& title, const std::string& path) {
    constexpr milliseconds kForOneTyping{5000};
    auto asked = says("modal", title);
    if (!asked) return asked;
    const auto is_open = [&] { return ask("open_dialog").find(title) != std::string::npos; };
    const auto stands_there = [&] { return ask("text fileNameEdit") == path; };
    const bool has_chosen = eventually([&] {
        if (!is_open()) return true;
        if (!stands_there()) {
            press({"ctrl+a"});
            type(path);
            const bool is_there = eventually([&] { return stands_there() || !is_open(); }, kForOneTyping);
            if (!is_there) std::printf("typed otherwise: %s\n", ask("text fileNameEdit").c_str());
            return false;
        }
        // The list of names that comes up while one types may take a Return for itself: then another is
        // needed.
        press({"Return"});
        return eventually([&] { return !is_open() || !stands_there(); }, kForOneTyping) && !is_open();
    });
    if (has_chosen) return ::testing::AssertionSuccess();
    take_picture("failed");
    return ::testing::AssertionFailure()
           << title << ": " << ask("text fileNameEdit") << ", not " << path << "; active: " << ask("modal");
}

void X11Rig::resize_window(int width, int height) {
    xdotool({"getactivewindow", "windowsize", "--sync", std::to_string(width), std::to_string(height)});
}

void X11Rig::press(const std::vector<std::string>& keys) {
    // What goes takes the keyboard with it, until the window manager has given it to whoever stays.
    EXPECT_TRUE(says("keyboard", "here"));
    std::vector<std::string> words{"key"};
    words.insert(words.end(), keys.begin(), keys.end());
    xdotool(words);
}

void X11Rig::type(const std::string& text) {
    xdotool({"type", "--delay", "5", text});
}

void X11Rig::xdotool(std::vector<std::string> words) {
    words.insert(words.begin(), "xdotool");
    EXPECT_EQ(run_to_end(words, environment_), 0) << words[1];
}

void X11Rig::take_picture(const std::string& name) {
    const std::string folder = in_build("screenshots");
    mkdir(folder.c_str(), 0755);
    EXPECT_EQ(ask("picture " + folder + "/x11_" + name + ".png"), "saved");
}

}  // namespace psicarve::test
