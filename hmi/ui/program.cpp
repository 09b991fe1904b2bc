// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/program.hpp"

#include <QApplication>
#include <QLocale>
#include <QTimer>
#include <cerrno>
#include <chrono>
#include <clocale>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "hmi/session/departure.hpp"
#include "hmi/ui/gl_probe.hpp"
#include "hmi/ui/gl_trial.hpp"
#include "hmi/ui/main_window.hpp"
#include "hmi/ui/quit_signals.hpp"
#include "hmi/ui/settings.hpp"
#include "hmi/ui/window_options.hpp"

namespace psicarve::ui {
namespace {

constexpr int kExitNotSaved = 3;
constexpr int kExitNotPrinted = 3;

/// So long the program waits for the language that was chosen; after that it is the desktop's.
constexpr std::chrono::milliseconds kLanguageLimit{250};

/// So long OpenGL has to have drawn the window before it is trusted.
constexpr std::chrono::seconds kTrial{3};

/// So long the first frame waits for the disk that remembers trials, each time; then it is drawn without
/// OpenGL.
constexpr std::chrono::milliseconds kTrialLimit{250};

/// How often it is asked for that then.
constexpr std::chrono::milliseconds kTrialLook{100};

Drawing drawing_for(OpenGl wanted, GlTrial& trial) {
    if (wanted == OpenGl::never) return Drawing::painter;
    if (wanted == OpenGl::automatic && trial.has_crashed_before(kTrialLimit).value_or(true))
        return Drawing::painter;
    if (!trial.begin(kTrialLimit)) {
        if (wanted == OpenGl::always)
            std::fprintf(stderr,
                         "psicarve-hmi: no OpenGL, as the disk does not keep that it is tried; "
                         "going on without\n");
        return Drawing::painter;
    }
    const GlProbe probe = probe_gl();
    if (wanted == OpenGl::always && !probe.is_usable)
        std::fprintf(stderr, "psicarve-hmi: no OpenGL here (%s); going on without\n",
                     probe.reason.toUtf8().constData());
    const bool is_wanted = wanted == OpenGl::always || !probe.is_software;
    if (probe.is_usable && is_wanted) return Drawing::opengl;
    trial.end();
    return Drawing::painter;
}

/// Numbers have decimal points in all languages, as in the files. Qt has just set the desktop's ways, which
/// C functions that read numbers follow.
void keep_decimal_points() {
    std::setlocale(LC_NUMERIC, "C");
    QLocale::setDefault(QLocale::c());
}

Language language_for(const WindowOptions& options, SettingsStore& settings) {
    if (const auto wanted = language_of(QString::fromStdString(options.language))) return *wanted;
    settings.await_read(kLanguageLimit);
    return WindowSettings{settings}.language().value_or(desktop_language());
}

/// As soon as it is known.
void tell_of_crash(MainWindow& window, GlTrial& trial) {
    const auto is_told = [&window, &trial] {
        const auto has_crashed = trial.has_crashed_before(std::chrono::milliseconds{0});
        if (has_crashed.value_or(false)) {
            window.context().log.add(
                session::Severity::warning,
                session::phrase("OpenGL took the window down the last time: drawing without it"),
                session::phrase("psicarve-hmi --opengl tries it again"));
        }
        return has_crashed.has_value();
    };
    if (is_told()) return;
    auto* const again = new QTimer{&window};
    QObject::connect(again, &QTimer::timeout, again, [again, is_told] {
        if (is_told()) again->stop();
    });
    again->start(kTrialLook);
}

/// Whatever disk hangs; what is being saved has its time.
void take_away(std::unique_ptr<MainWindow> window, std::unique_ptr<GlTrial> trial, int exit_code) {
    window->hide();
    QApplication::processEvents(QEventLoop::ExcludeUserInputEvents);
    const session::DepartureWatch watch{window->context().saves, [exit_code](bool is_lost) {
                                            std::fflush(stdout);
                                            std::_Exit(is_lost ? kExitNotSaved : exit_code);
                                        }};
    window.reset();
    trial.reset();
}

/// Help, the version, or what is wrong with the command line.
int print_and_end(const WindowOptions& options) {
    const int exit_code = *options.exit_code;
    std::FILE* const stream = exit_code == 0 ? stdout : stderr;
    std::fputs(options.text.c_str(), stream);
    if (std::fflush(stream) == 0 && std::ferror(stream) == 0) return exit_code;
    std::fprintf(stderr, "psicarve-hmi: standard output: %s\n", std::strerror(errno));
    return exit_code == 0 ? kExitNotPrinted : exit_code;
}

}  // namespace

int run(int argc, char** argv) {
    const WindowOptions options = parse_window_options({argv + 1, argv + argc});
    if (options.exit_code) return print_and_end(options);
    QApplication application{argc, argv};
    QApplication::setApplicationName("psicarve-hmi");
    QApplication::setApplicationDisplayName("Psicarve");
    QApplication::setDesktopFileName("org.psicarve.hmi");  // its icon and name where Wayland looks for them
    QApplication::setStyle("Fusion");
    keep_decimal_points();
    auto settings = std::make_unique<SettingsStore>();
    use_language(language_for(options, *settings));
    auto trial =
        std::make_unique<GlTrial>(session::state_folder(std::getenv("XDG_STATE_HOME"), std::getenv("HOME")));
    const Drawing drawing = drawing_for(options.opengl, *trial);
    session::SessionOptions session_options{options.segment_name, options.group, {}};
    session_options.state_folder = options.state_folder;
    auto window = std::make_unique<MainWindow>(session_options, drawing, std::move(settings));
    if (options.opengl == OpenGl::automatic && drawing == Drawing::painter) tell_of_crash(*window, *trial);
    const QuitSignals signals_to_quit{[&window] {
        if (window) window->leave();  // not while it is taken away
        QCoreApplication::exit(0);    // quit() would ask
    }};
    window->show();
    window->begin_with(QString::fromStdString(options.profile_path), QString::fromStdString(options.path));
    if (drawing == Drawing::opengl) QTimer::singleShot(kTrial, window.get(), [&trial] { trial->end(); });
    const int exit_code = QApplication::exec();
    if (drawing == Drawing::opengl) trial->end();
    take_away(std::move(window), std::move(trial), exit_code);
    return exit_code;
}

}  // namespace psicarve::ui
