// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <ctime>
#include <memory>
#include <span>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "shared/file/atomic_file.hpp"
#include "shared/segment/segment.hpp"
#include "shared/segment/shared_record.hpp"
#include "tests/fake_port/fake_port_file.hpp"
#include "tests/two_process/core_process.hpp"

namespace psicarve::bench {

inline constexpr std::chrono::milliseconds kPatience{5000};

/// CLOCK_MONOTONIC, as the fake port stamps its writes.
inline std::int64_t now_ns() {
    timespec now{};
    clock_gettime(CLOCK_MONOTONIC, &now);
    return std::int64_t{now.tv_sec} * 1'000'000'000 + now.tv_nsec;
}

inline double percentile(std::vector<double> values, double share) {
    std::sort(values.begin(), values.end());
    return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}

/// A core of its own on the fake port, whose folder this is; it ends with the object.
class CoreOnFakePort {
public:
    CoreOnFakePort(std::string folder, double period_us)
        : folder_(std::move(folder)), profile_(machine(period_us)) {
        const std::string text = profile_to_toml(profile_);
        const std::string path = folder_ + "/machine.toml";
        (void)write_file_atomically(path, std::as_bytes(std::span{text}));
        port_ = std::make_unique<fake_port::FakePortFile>(folder_, profile_);
        const fake_port::FakePortFile::Preload preload{*port_};
        core_ = std::make_unique<two_process::CoreProcess>(
            std::vector<std::string>{"--segment", name_, "--profile", path, "--port",
                                     "ppdev:" + port_->device(), "--capacity", "10x10",
                                     "--allow-no-realtime"},
            folder_ + "/core.err");
    }
    ~CoreOnFakePort() {
        core_->send_signal(SIGTERM);
        core_->wait_for_exit();
        (void)Segment::remove(name_);
    }
    CoreOnFakePort(const CoreOnFakePort&) = delete;
    CoreOnFakePort& operator=(const CoreOnFakePort&) = delete;

    /// False: it has not come up within five seconds.
    bool attach() {
        for (int i = 0; i < 500 && !segment_; ++i) {
            auto attached = Segment::attach(name_);
            if (attached && attached->core_pid()) segment_ = std::make_unique<Segment>(std::move(*attached));
            std::this_thread::sleep_for(std::chrono::milliseconds{10});
        }
        return segment_ != nullptr;
    }
    bool send(CommandKind kind, double value = 0.0) {
        Command command{};
        command.kind = kind;
        command.value = value;
        return send_command(*segment_, command, kPatience).has_value();
    }
    /// As often as it takes, for five seconds: slots may be full, and a switch may have opened just now.
    bool send_until_done(CommandKind kind) {
        const std::int64_t end_ns = now_ns() + std::chrono::nanoseconds{kPatience}.count();
        while (!send(kind)) {
            if (now_ns() > end_ns) return false;
            std::this_thread::sleep_for(std::chrono::milliseconds{1});
        }
        return true;
    }
    CoreStatus status() const { return read_record(segment_->header().status).value_or(CoreStatus{}); }
    /// The axes are a few pulses off their sensors again, as if a hand had turned them back.
    void stand() { port_->stand(profile_); }
    const std::string& name() const noexcept { return name_; }
    Segment& segment() noexcept { return *segment_; }
    const Segment& segment() const noexcept { return *segment_; }
    std::uint64_t write_count() const { return port_->state().write_count.load(); }
    /// When the first write since the `from`-th (counted from 0) of the wire's register put the wire to `on`;
    /// negative: none has within five seconds. CLOCK_MONOTONIC.
    std::int64_t seen_on_wire_ns(const fake_port::Wire& wire, bool on, std::uint64_t from) const {
        const auto& state = port_->state();
        for (int i = 0; i < 25'000; ++i) {
            const std::uint64_t count = state.write_count.load();
            for (; from < count; ++from) {
                const fake_port::Write& write = state.writes[from % fake_port::kMostWrites];
                if (write.reg == wire.reg && (write.value >> wire.bit & 1U) == (on ? 1U : 0U))
                    return static_cast<std::int64_t>(write.time_ns);
            }
            std::this_thread::sleep_for(std::chrono::microseconds{200});
        }
        return -1;
    }

private:
    static Profile machine(double period_us) {
        Profile profile;
        profile.tick.period_us = period_us;
        profile.tick.missed_alarm_per_s = 0;
        for (LinearAxisProfile* axis : {&profile.r1, &profile.r2, &profile.y}) {
            axis->speed_mm_s = 4.0;
            axis->home_speed_mm_s = 4.0;
            axis->start_stop_mm_s = 0.02;
        }
        profile.psi.speed_deg_s = 90.0;
        // A gap of ticks while it homes, as a shared computer has them, does not end the run.
        profile.psi.start_stop_deg_s = 0.5;
        return profile;
    }

    std::string folder_;
    std::string name_ = "/psicarve-bench-" + std::to_string(getpid());
    Profile profile_;
    std::unique_ptr<fake_port::FakePortFile> port_;
    std::unique_ptr<two_process::CoreProcess> core_;
    std::unique_ptr<Segment> segment_;
};

}  // namespace psicarve::bench
