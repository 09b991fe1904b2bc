// SPDX-License-Identifier: GPL-3.0-or-later
// The operator's window: start to usable; the longest turn of its thread while two million triangles are
// loaded and sliced; frames of the carving view (500 x 500 points) beside a core; click to command; memory;
// the core's death seen.
//   bench_window [--judge] [--opengl] [LAYERS POINTS]      on the screen of DISPLAY, or
//   QT_QPA_PLATFORM=offscreen
// --judge: the exit code tells what was promised from what was measured. 0: kept; 1: something did not work
// at all; 2: broken; 3: over a limit, but not by its own work, as other programs took the processor.
#include <time.h>
#include <unistd.h>

#include <QSettings>
#include <QSpinBox>
#include <QTemporaryDir>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string>

#include "hmi/machine/core_process.hpp"
#include "hmi/ui/gl_probe.hpp"
#include "tests/bench/window/window_stages.hpp"
#include "tests/places.hpp"

namespace {

using namespace psicarve;

constexpr int kUsual = 500;
constexpr double kStartLimit_ms = 1000.0;

/// Since the kernel began with this process; it counts in hundredths of a second.
double age_ms() {
    std::ifstream file{"/proc/self/stat"};
    std::string text{std::istreambuf_iterator<char>{file}, {}};
    std::istringstream fields{text.substr(text.rfind(')') + 2)};
    std::string field;
    constexpr int kStartTime = 20;  // counted from the one after the name
    for (int i = 0; i < kStartTime; ++i) fields >> field;
    timespec now{};
    ::clock_gettime(CLOCK_BOOTTIME, &now);
    const double now_ms = static_cast<double>(now.tv_sec) * 1e3 + static_cast<double>(now.tv_nsec) * 1e-6;
    return now_ms - std::stod(field) * 1e3 / static_cast<double>(::sysconf(_SC_CLK_TCK));
}

/// The processor's time that all threads together have used.
double process_ms() {
    timespec used{};
    ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &used);
    return static_cast<double>(used.tv_sec) * 1e3 + static_cast<double>(used.tv_nsec) * 1e-6;
}

int judged(context::Judge::Verdict verdict) {
    using V = context::Judge::Verdict;
    std::puts(verdict == V::kept ? "judged: all that is promised is kept"
              : verdict == V::disturbed
                  ? "judged: over a limit, but not by its own work; measure again with less beside it"
                  : "judged: a promise is broken");
    return verdict == V::kept ? 0 : verdict == V::broken ? 2 : 3;
}

}  // namespace

int main(int argc, char** argv) {
    int sizes = 1;
    const auto takes = [&](const char* option) {
        const bool is_there = argc > sizes && std::string{argv[sizes]} == option;
        sizes += is_there ? 1 : 0;
        return is_there;
    };
    const bool judges = takes("--judge");
    const bool wants_opengl = takes("--opengl");
    const int layers = argc > sizes + 1 ? std::atoi(argv[sizes]) : kUsual;
    const int points = argc > sizes + 1 ? std::atoi(argv[sizes + 1]) : kUsual;
    const char* path = std::getenv("PATH");
    setenv("PATH", (in_build("bin:") + (path != nullptr ? path : "")).c_str(), 1);
    context::WatchedApplication application{argc, argv};
    QApplication::setStyle("Fusion");
    const QTemporaryDir folder;
    QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, folder.path());
    const ui::GlProbe probe = ui::probe_gl();
    const auto drawing = wants_opengl && probe.is_usable ? ui::Drawing::opengl : ui::Drawing::painter;
    const std::string segment = "/psicarve-bench-" + std::to_string(getpid());
    ui::MainWindow window{{segment, {}, {}}, drawing};
    window.show();
    application.processEvents();
    window.refresh();
    application.processEvents();
    std::printf("platform %s, drawn with %s %s\n", QGuiApplication::platformName().toUtf8().constData(),
                drawing == ui::Drawing::opengl ? "OpenGL" : "QPainter", probe.renderer.toUtf8().constData());
    const double start_ms = age_ms();
    std::printf("start to usable window: %.0f ms, of the %.0f ms wanted\n", start_ms, kStartLimit_ms);
    context::Judge judge;
    judge.look(start_ms, process_ms(), kStartLimit_ms);
    context::print_memory("of the empty window");
    machine::CoreLaunch launch;
    launch.segment_name = segment;
    launch.is_private = true;
    launch.capacity_layers = static_cast<std::uint32_t>(std::max(layers, kUsual));
    launch.capacity_points = static_cast<std::uint32_t>(std::max(points, kUsual));
    auto core = machine::CoreProcess::start(launch);
    if (!core) {
        std::fprintf(stderr, "bench_window: %s\n", core.error().message.c_str());
        return 1;
    }
    window.findChild<QSpinBox*>("layers")->setValue(layers);
    window.findChild<QSpinBox*>("points")->setValue(points);
    const bool is_done = context::load_and_slice(application, window, folder.path().toStdString(), judge) &&
                         context::carve(application, window, judge) &&
                         context::press_buttons(application, window, judge) &&
                         context::lose_core(application, window, core->pid(), judge);
    if (!is_done) return 1;
    return judges ? judged(judge.verdict()) : 0;
}
