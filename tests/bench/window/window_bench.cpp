// SPDX-License-Identifier: GPL-3.0-or-later
// The operator's window: start to usable; the longest turn of its thread while two million triangles are
// loaded and sliced; frames of the carving view (500 x 500 points) beside a core; click to command; memory.
//   bench_window [--opengl] [LAYERS POINTS]      on the screen of DISPLAY, or QT_QPA_PLATFORM=offscreen
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

namespace {

using namespace psicarve;

constexpr int kUsual = 500;

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

}  // namespace

int main(int argc, char** argv) {
    const bool wants_opengl = argc > 1 && std::string{argv[1]} == "--opengl";
    const int sizes = wants_opengl ? 2 : 1;
    const int layers = argc > sizes + 1 ? std::atoi(argv[sizes]) : kUsual;
    const int points = argc > sizes + 1 ? std::atoi(argv[sizes + 1]) : kUsual;
    const char* path = std::getenv("PATH");
    setenv("PATH", (std::string{PSICARVE_BIN} + ":" + (path != nullptr ? path : "")).c_str(), 1);
    bench::WatchedApplication application{argc, argv};
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
    std::printf("start to usable window: %.0f ms, of the 1000 ms wanted\n", age_ms());
    bench::print_memory("of the empty window");
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
    const bool is_done = bench::load_and_slice(application, window, folder.path().toStdString()) &&
                         bench::carve(application, window) && bench::press_buttons(application, window);
    return is_done ? 0 : 1;
}
