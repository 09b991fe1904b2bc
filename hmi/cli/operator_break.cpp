// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/cli/operator_break.hpp"

#include <atomic>

#include "hmi/cli/exit_code.hpp"

namespace psicarve::cli {
namespace {

constexpr int kStop = 1;
constexpr int kEmergencyStop = 2;

// A signal handler can use nothing else.
std::atomic<int> break_count{0};
std::atomic<unsigned> breaks_ever{0};  ///< of all waits together
std::atomic<bool> third_ends_us{false};
struct sigaction interrupt_before {};
struct sigaction terminate_before {};
struct sigaction hang_up_before {};
static_assert(std::atomic<int>::is_always_lock_free && std::atomic<bool>::is_always_lock_free &&
              std::atomic<unsigned>::is_always_lock_free);

struct sigaction& action_before(int number) {
    if (number == SIGINT) return interrupt_before;
    return number == SIGTERM ? terminate_before : hang_up_before;
}

extern "C" void count_break(int number) {
    breaks_ever.fetch_add(1, std::memory_order_relaxed);
    const int count = break_count.fetch_add(1, std::memory_order_relaxed) + 1;
    if (count <= kEmergencyStop || !third_ends_us.load()) return;
    // Restores the old handler; the signal is delivered as soon as this one returns.
    sigaction(number, &action_before(number), nullptr);
    raise(number);
}

void install(int number) {
    struct sigaction action {};
    action.sa_handler = count_break;
    sigemptyset(&action.sa_mask);
    struct sigaction former {};
    sigaction(number, &action, &former);
    if (former.sa_handler != count_break) action_before(number) = former;
}

}  // namespace

OperatorBreak::OperatorBreak() {
    break_count = 0;
    third_ends_us = false;
    install(SIGINT);
    install(SIGTERM);
}

void OperatorBreak::take_hang_up() {
    struct sigaction now {};
    sigaction(SIGHUP, nullptr, &now);
    if (now.sa_handler == SIG_IGN) return;
    install(SIGHUP);
    takes_hang_up_ = true;
}

OperatorBreak::~OperatorBreak() {
    // The program ends on request now: a further signal on the way out must not change how it ends.
    if (was_asked()) {
        third_ends_us = true;
        return;
    }
    sigaction(SIGINT, &interrupt_before, nullptr);
    sigaction(SIGTERM, &terminate_before, nullptr);
    if (takes_hang_up_) sigaction(SIGHUP, &hang_up_before, nullptr);
}

void OperatorBreak::let_third_end_us() noexcept {
    third_ends_us = true;
}

bool OperatorBreak::was_asked() const noexcept {
    return break_count.load(std::memory_order_relaxed) > 0;
}

unsigned OperatorBreak::asked_ever() noexcept {
    return breaks_ever.load(std::memory_order_relaxed);
}

Result<void> OperatorBreak::pass_on(machine::MachineLink& link) {
    const int asked = break_count.load(std::memory_order_relaxed);
    if (passed_on_ < kStop && asked >= kStop) {
        passed_on_ = kStop;
        print_note("stopping the machine; once more for an emergency stop");
        link.stop();
    }
    if (passed_on_ < kEmergencyStop && asked >= kEmergencyStop) {
        passed_on_ = kEmergencyStop;
        print_note("emergency stop");
        link.emergency_stop();
    }
    if (asked > kEmergencyStop)
        return Error{ErrorCode::cancelled, "interrupted; the machine was left as it is"};
    return {};
}

Error OperatorBreak::error(const CoreStatus& last) const {
    std::string text =
        passed_on_ >= kEmergencyStop ? "emergency stop by the operator" : "stopped by the operator";
    if (last.points_done > 0) {
        text += " after " + std::to_string(last.points_done) + " of " + std::to_string(last.points_total) +
                " points (layer " + std::to_string(last.layer) + ", point " + std::to_string(last.point) +
                ")";
    }
    return Error{ErrorCode::cancelled, text};
}

}  // namespace psicarve::cli
