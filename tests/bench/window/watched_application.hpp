// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QApplication>
#include <QElapsedTimer>

#include <functional>
#include <string>
#include <vector>

namespace psicarve::context {

/// How long the window's thread was busy with one thing.
struct Turn {
    double wall_ms = 0.0;
    double cpu_ms = 0.0;  ///< of this thread alone: without the time in which the computer did something else
    std::string what;     ///< the event, and whom it was for
};

/// An application that takes the time of every event it hands on, painting included.
class WatchedApplication : public QApplication {
public:
    WatchedApplication(int& argument_count, char** arguments) : QApplication(argument_count, arguments) {}

    bool notify(QObject* receiver, QEvent* event) override;
    /// Handles events until the condition holds; false after `limit_s`.
    bool run_until(const std::function<bool()>& condition, double limit_s = 600.0);
    void run_for(double seconds);
    /// Since the last call, longest first.
    std::vector<Turn> take_turns();
    /// The name of the view whose canvas is watched.
    void watch_view(const char* name) { watched_view_ = name; }
    /// How long each painting of the canvas took since the last call.
    std::vector<double> take_paints_ms();

private:
    bool paint(QObject* receiver, QEvent* event);

    int depth_ = 0;
    QString watched_view_;
    std::vector<double> paints_ms_;
    std::vector<Turn> turns_;
};

}  // namespace psicarve::context
