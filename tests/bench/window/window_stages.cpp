// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/window/window_stages.hpp"

#include <QAbstractButton>
#include <QMouseEvent>
#include <QSpinBox>
#include <QTabWidget>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <fstream>
#include <thread>

#include "hmi/machine/machine_link.hpp"
#include "hmi/ui/mesh_view.hpp"
#include "hmi/ui/state_pill.hpp"
#include "tests/bench/slice/measure.hpp"
#include "tests/bench/slice/relief_mesh.hpp"

namespace psicarve::context {
namespace {

using session::OpenJobState;
using Clock = std::chrono::steady_clock;
using S = MachineState;

constexpr std::size_t kTriangles = 2'000'000;
constexpr double kBlockTarget_ms = 50.0;
constexpr double kLossTarget_ms = 500.0;
constexpr int kPresses = 40;
constexpr double kSliceLimit_s = 120.0;  // also when the numbers asked for are refused
/// Less is the picture before, put there once more.
constexpr double kDrawnAnew_ms = 0.5;
constexpr double kWatch_ms = 3000.0;
constexpr int kModelTab = 0;
constexpr int kLayersTab = 1;
constexpr int kCarvingTab = 2;
constexpr int kMessagesTab = 5;

double since_ms(Clock::time_point begin) {
    return std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
}

std::string write_stl(const model::Mesh& mesh, const std::string& folder) {
    const std::string path = folder + "/two_million.stl";
    std::ofstream file{path, std::ios::binary};
    const std::string head(80, ' ');
    file << head;
    const auto count = static_cast<std::uint32_t>(mesh.triangles.size());
    file.write(reinterpret_cast<const char*>(&count), sizeof count);
    constexpr char kNormal[12]{};
    constexpr char kAttributes[2]{};
    for (const model::Triangle& triangle : mesh.triangles) {
        file.write(kNormal, sizeof kNormal);
        file.write(reinterpret_cast<const char*>(&triangle), sizeof triangle);
        file.write(kAttributes, sizeof kAttributes);
    }
    return path;
}

QTabWidget& tabs(ui::MainWindow& window) {
    return *window.findChild<QTabWidget*>();
}

void press(QAbstractButton& button) {
    const QPointF middle = QRectF{button.rect()}.center();
    const QPointF on_screen = button.mapToGlobal(middle);
    QMouseEvent down{QEvent::MouseButtonPress, middle,         on_screen,
                     Qt::LeftButton,           Qt::LeftButton, Qt::NoModifier};
    QMouseEvent up{
        QEvent::MouseButtonRelease, middle, on_screen, Qt::LeftButton, Qt::NoButton, Qt::NoModifier};
    QApplication::sendEvent(&button, &down);
    QApplication::sendEvent(&button, &up);
}

const session::MachineView& machine_view(ui::MainWindow& window) {
    return window.context().machine.view();
}

bool comes_to(WatchedApplication& application, ui::MainWindow& window, S state) {
    return application.run_until(
        [&] { return machine_view(window).is_heard() && machine_view(window).state() == state; }, 60.0);
}

bool click(WatchedApplication& application, ui::MainWindow& window, const char* name) {
    auto* const button = window.findChild<QAbstractButton*>(name);
    if (!application.run_until([button] { return button->isEnabled(); }, 60.0)) {
        std::fprintf(stderr, "%s: %s\n", name, button->toolTip().toUtf8().constData());
        return false;
    }
    press(*button);
    return true;
}

/// When the core's status shows another state than this one; looked for all the time.
Clock::time_point when_left(const machine::MachineLink& link, S state) {
    const auto end = Clock::now() + std::chrono::seconds{30};
    while (Clock::now() < end) {
        const auto status = link.last_status();
        if (status && status->state != state) break;
        std::this_thread::sleep_for(std::chrono::microseconds{20});
    }
    return Clock::now();
}

double part_of(const std::vector<double>& sorted, double part) {
    if (sorted.empty()) return 0.0;
    return sorted[std::min(sorted.size() - 1,
                           static_cast<std::size_t>(part * static_cast<double>(sorted.size())))];
}

/// A carving from its begin, whatever the machine does.
bool start_anew(WatchedApplication& application, ui::MainWindow& window) {
    if (machine_view(window).state() == S::carving) window.context().machine.stop();
    return comes_to(application, window, S::ready) && click(application, window, "start") &&
           comes_to(application, window, S::carving);
}

/// All that the window's thread did in a second of carving [ms], with this page in front.
double busy_ms_per_s(WatchedApplication& application, ui::MainWindow& window, int page) {
    tabs(window).setCurrentIndex(page);
    if (!start_anew(application, window)) return 0.0;
    application.take_turns();
    application.take_paints_ms();
    const auto begin = Clock::now();
    application.run_until(
        [&] { return since_ms(begin) > kWatch_ms || machine_view(window).state() != S::carving; });
    double busy_ms = 0.0;
    for (const Turn& turn : application.take_turns()) busy_ms += turn.cpu_ms;
    return busy_ms / since_ms(begin) * 1e3;
}

}  // namespace

void print_memory(const char* when) {
    std::ifstream file{"/proc/self/status"};
    double all_mb = 0.0;
    double own_mb = 0.0;
    for (std::string word; file >> word;) {
        double kb = 0.0;
        if (word == "VmRSS:" && file >> kb) all_mb = kb / 1e3;
        if (word == "RssAnon:" && file >> kb) own_mb = kb / 1e3;
    }
    std::printf("memory %-34s %7.1f MB, of it its own %7.1f MB\n", when, all_mb, own_mb);
}

void print_longest(WatchedApplication& application, const char* stage, Judge& judge) {
    const auto turns = application.take_turns();
    if (turns.empty()) return;
    for (const Turn& turn : turns) judge.look(turn.wall_ms, turn.cpu_ms, kBlockTarget_ms);
    const Turn& longest = turns.front();
    std::printf("longest turn, %-26s %7.2f ms (its own %7.2f ms): %s; %.2f of the %.0f ms allowed\n", stage,
                longest.wall_ms, longest.cpu_ms, longest.what.c_str(), longest.wall_ms / kBlockTarget_ms,
                kBlockTarget_ms);
}

bool load_and_slice(WatchedApplication& application, ui::MainWindow& window, const std::string& folder,
                    Judge& judge) {
    const std::string path = write_stl(relief_mesh(kTriangles), folder);
    session::OpenJob& desk = window.context().open_job;
    tabs(window).setCurrentIndex(kModelTab);
    application.run_for(0.5);
    application.take_turns();
    auto begin = Clock::now();
    window.open(QString::fromStdString(path));
    if (!application.run_until([&] { return desk.view().state == OpenJobState::model; })) return false;
    std::printf("%zu triangles: opened in %.0f ms\n", desk.mesh()->triangles.size(), since_ms(begin));
    print_longest(application, "opening", judge);
    auto* const view = static_cast<ui::MeshView*>(window.findChild<QWidget*>("model_view"));
    begin = Clock::now();
    const auto is_painted = [view] {
        const auto& bodies = view->picture().bodies;
        return !bodies.empty() && !bodies.front().scene->vertex_rgb.empty();
    };
    if (!application.run_until(is_painted)) return false;
    std::printf("undercut found in %.0f ms, drawn with %zu facets (%zu while turned)\n", since_ms(begin),
                view->picture().bodies.front().scene->facets.size(),
                view->picture().bodies.front().scene->coarse_facets.size());
    application.run_for(0.5);
    print_longest(application, "looking for undercut", judge);
    begin = Clock::now();
    if (!click(application, window, "slice")) return false;
    if (!application.run_until([&] { return desk.view().state == OpenJobState::job; }, kSliceLimit_s))
        return false;
    std::printf("sliced in %.0f ms\n", since_ms(begin));
    application.run_for(0.5);
    print_longest(application, "slicing", judge);
    tabs(window).setCurrentIndex(kLayersTab);
    application.run_for(1.0);
    print_longest(application, "showing the layers", judge);
    print_memory("with the model and its job");
    return true;
}

bool carve(WatchedApplication& application, ui::MainWindow& window, Judge& judge) {
    if (!click(application, window, "publish")) return false;
    const auto is_published = [&] {
        return window.context().open_job.view().state == OpenJobState::published;
    };
    if (!application.run_until(is_published, 60.0)) return false;
    tabs(window).setCurrentIndex(kCarvingTab);
    application.run_for(1.0);
    print_longest(application, "publishing, Carving", judge);
    if (!click(application, window, "home") || !comes_to(application, window, S::ready)) return false;
    application.watch_view("carving_view");
    const double messages_ms = busy_ms_per_s(application, window, kMessagesTab);
    const double carving_ms = busy_ms_per_s(application, window, kCarvingTab);
    auto frames_ms = application.take_paints_ms();
    std::erase_if(frames_ms, [](double ms) { return ms < kDrawnAnew_ms; });
    std::sort(frames_ms.begin(), frames_ms.end());
    const auto& job = window.context().open_job.job()->view;
    std::printf(
        "carving view, %u x %u points beside the core: %zu frames drawn anew, median %.2f ms, p99 %.2f ms, "
        "max %.2f "
        "ms\n",
        job.layer_count(), job.point_count(), frames_ms.size(), part_of(frames_ms, 0.5),
        part_of(frames_ms, 0.99), part_of(frames_ms, 1.0));
    std::printf(
        "window's thread while carving: %.0f ms a second with Carving in front, %.0f with Messages, %.2f "
        "times\n",
        carving_ms, messages_ms, carving_ms / std::max(messages_ms, 1.0));
    print_memory("while carving");
    return true;
}

bool press_buttons(WatchedApplication& application, ui::MainWindow& window, Judge& judge) {
    auto link = machine::MachineLink::attach(window.context().machine.options().segment_name);
    if (!link) return false;
    std::vector<double> pressed_ms;
    std::vector<double> sent_ms;
    if (!start_anew(application, window)) return false;
    for (int i = 0; i < kPresses; ++i) {
        const bool is_carving = i % 2 == 0;
        const S from = is_carving ? S::carving : S::held;
        if (!comes_to(application, window, from)) return false;
        const bool by_mouse = i / 2 % 2 == 0;
        std::atomic<Clock::time_point::rep> taken{0};
        std::thread witness{[&] { taken = when_left(*link, from).time_since_epoch().count(); }};
        const auto begin = Clock::now();
        bool is_sent = true;
        if (by_mouse)
            is_sent = click(application, window, is_carving ? "hold" : "resume");
        else
            is_sent = bool(link->send(is_carving ? CommandKind::hold : CommandKind::resume));
        application.run_until([&taken] { return taken.load() != 0; }, 30.0);
        witness.join();
        if (!is_sent) return false;
        const Clock::time_point end{Clock::duration{taken.load()}};
        (by_mouse ? pressed_ms : sent_ms)
            .push_back(std::chrono::duration<double, std::milli>(end - begin).count());
    }
    std::printf(
        "mouse event to the core having taken the command: median %.2f ms, max %.2f ms; without a "
        "window %.2f ms, %.2f times\n",
        median(pressed_ms), *std::max_element(pressed_ms.begin(), pressed_ms.end()), median(sent_ms),
        median(pressed_ms) / median(sent_ms));
    print_longest(application, "pressing buttons", judge);
    return true;
}

bool lose_core(WatchedApplication& application, ui::MainWindow& window, pid_t core, Judge& judge) {
    if (!start_anew(application, window)) return false;
    auto* const pill = static_cast<ui::StatePill*>(window.findChild<QWidget*>("state_pill"));
    const auto begin = Clock::now();
    if (::kill(core, SIGKILL) != 0) return false;
    if (!application.run_until([pill] { return pill->word() == "NO CORE"; }, 60.0)) return false;
    application.processEvents();  // painted
    const double taken_ms = since_ms(begin);
    std::printf("core killed to the window saying so: %.0f ms, of the %.0f ms allowed\n", taken_ms,
                kLossTarget_ms);
    judge.look(taken_ms, taken_ms, kLossTarget_ms);  // a wait is no excuse here
    return true;
}

}  // namespace psicarve::context
