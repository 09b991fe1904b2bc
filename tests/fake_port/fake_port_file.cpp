// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fake_port/fake_port_file.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <linux/parport.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <new>
#include <utility>

#include "shared/machine/signal.hpp"
#include "shared/profile/pin_map.hpp"
#include "tests/places.hpp"

namespace psicarve::fake_port {
namespace {

void* map_file(const std::string& path) {
    const int file = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
    void* address = MAP_FAILED;
    if (file >= 0 && ::ftruncate(file, sizeof(State)) == 0) {
        address = ::mmap(nullptr, sizeof(State), PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
    }
    if (file >= 0) ::close(file);
    if (address == MAP_FAILED) ADD_FAILURE() << path << ": cannot be mapped";
    return address;
}

// The default pin map once more, written apart: docs/hardware.md.
void wire(State& state) {
    constexpr auto kData = Register::data;
    constexpr auto kControl = Register::control;
    const auto put = [&](Axis axis, Wire step, Wire dir, Wire enable, int status_bit, bool is_inverted) {
        FakeAxis& to = state.axes[index_of(axis)];
        to.step = step;
        to.dir = dir;
        to.enable = enable;
        to.status_bit = static_cast<std::uint8_t>(status_bit);
        to.is_status_inverted = is_inverted ? 1 : 0;
    };
    put(Axis::r1, {kData, 3, 0}, {kData, 7, 0}, {kData, 4, 0}, 4, false);
    put(Axis::r2, {kData, 0, 0}, {kControl, 3, 1}, {kData, 5, 0}, 7, true);
    put(Axis::psi, {kData, 1, 0}, {kData, 6, 0}, {kData, 4, 0}, 5, false);
    put(Axis::y, {kControl, 1, 1}, {kData, 2, 0}, {kControl, 0, 1}, 6, false);
}

/// So near, because tests home on the real clock.
constexpr std::int64_t kOffSensor_pulses = 12;

Sensor sensor_for(HomeSensor home) {
    switch (home) {
        case HomeSensor::none:
            return Sensor::none;
        case HomeSensor::max:
            return Sensor::above;
        case HomeSensor::min:
            return Sensor::below;
        case HomeSensor::index:
            break;
    }
    return Sensor::index;
}

}  // namespace

FakePortFile::FakePortFile(const std::string& folder, const Profile& profile)
    : device_(folder + "/parport0"), state_path_(folder + "/port.state") {
    const int device = ::open(device_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
    if (device >= 0) ::close(device);
    void* const address = map_file(state_path_);
    if (address == MAP_FAILED) std::abort();
    state_ = new (address) State{};
    constexpr std::uint32_t kAfterBoot = 0x0c;  // as parport_pc leaves the control register
    state_->control.store(kAfterBoot);
    state_->modes.store(PARPORT_MODE_PCSPP | PARPORT_MODE_TRISTATE);
    state_->accesses_to_fault.store(-1);
    wire(*state_);
    stand(profile);
}

FakePortFile::~FakePortFile() {
    ::munmap(state_, sizeof(State));
}

void FakePortFile::stand(const Profile& profile) {
    for (const Axis axis : kAllAxes) {
        const AxisMotion motion = axis_motion(profile, axis);
        FakeAxis& to = state_->axes[index_of(axis)];
        to.edge_pulses = motion.home_position_pulses;
        to.sensor = sensor_for(motion.home);
        to.position_pulses.store(to.edge_pulses +
                                 (to.sensor == Sensor::above ? -kOffSensor_pulses : kOffSensor_pulses));
    }
    FakeAxis& psi = state_->axes[index_of(Axis::psi)];
    psi.pulses_per_rev = profile.psi.pulses_per_rev;
    psi.index_pulses = std::max<std::int64_t>(1, profile.psi.pulses_per_rev / 400);
    psi.position_pulses.store(psi.edge_pulses - kOffSensor_pulses);
}

FakePortFile::Preload::Preload(const FakePortFile& port) {
    ::setenv("LD_PRELOAD", in_build("tests/fake_port_preload.so").c_str(), 1);
    const char* const options = std::getenv("ASAN_OPTIONS");
    if (options != nullptr) asan_options_ = options;
    // The library comes first, and is none of it.
    ::setenv("ASAN_OPTIONS", (asan_options_.value_or("") + ":verify_asan_link_order=0").c_str(), 1);
    ::setenv(kDeviceVariable, port.device_.c_str(), 1);
    ::setenv(kStateVariable, port.state_path_.c_str(), 1);
}

FakePortFile::Preload::~Preload() {
    ::unsetenv("LD_PRELOAD");
    if (asan_options_) {
        ::setenv("ASAN_OPTIONS", asan_options_->c_str(), 1);
    } else {
        ::unsetenv("ASAN_OPTIONS");
    }
    ::unsetenv(kDeviceVariable);
    ::unsetenv(kStateVariable);
}

std::vector<Write> FakePortFile::writes() const {
    const auto count = static_cast<std::size_t>(state_->write_count.load());
    EXPECT_LE(count, kMostWrites) << "more writes than the record has room for";
    const auto* const first = state_->writes.data();
    return {first, first + std::min(count, kMostWrites)};
}

void add_pulses(std::uint32_t before, std::uint32_t now, std::vector<Pulse>& pulses) {
    for (std::size_t k = 0; k < kAxisCount; ++k) {
        const SignalWord step = SignalWord{1} << k;
        if ((now & ~before & step) == 0) continue;
        pulses.push_back({static_cast<std::uint8_t>(k), (now & bit_of(dir_of(kAllAxes[k]))) != 0});
    }
}

std::vector<std::uint32_t> levels_of(const std::vector<Write>& writes, const Profile& profile) {
    const PinMap map = PinMap::from_profile(profile).value();
    OutputRegisters registers = map.encode(0);
    std::vector<std::uint32_t> levels;
    levels.reserve(writes.size());
    for (const Write& write : writes) {
        (write.reg == Register::data ? registers.data : registers.control) = write.value;
        levels.push_back(map.outputs_from_registers(registers) & kOutputMask);
    }
    return levels;
}

std::vector<Pulse> pulses_of(const std::vector<Write>& writes, const Profile& profile) {
    std::vector<Pulse> pulses;
    std::uint32_t before = 0;
    for (const std::uint32_t now : levels_of(writes, profile)) {
        add_pulses(before, now, pulses);
        before = now;
    }
    return pulses;
}

std::vector<std::vector<Pulse>> runs_with_spindle(const std::vector<std::uint32_t>& levels) {
    std::vector<std::vector<Pulse>> runs;
    std::vector<Pulse> run;
    std::uint32_t before = 0;
    const auto end_run = [&] {
        if (!run.empty()) runs.push_back(std::move(run));
        run.clear();
    };
    for (const std::uint32_t now : levels) {
        const bool turns = (now & bit_of(Signal::spindle)) != 0;
        if (turns) add_pulses(before, now, run);
        if (!turns) end_run();
        before = now;
    }
    end_run();
    return runs;
}

std::vector<Pulse> pulses_with_spindle(const std::vector<std::uint32_t>& levels) {
    const auto runs = runs_with_spindle(levels);
    return runs.empty() ? std::vector<Pulse>{} : runs.front();
}

}  // namespace psicarve::fake_port
