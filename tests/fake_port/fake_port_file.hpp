// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "shared/profile/profile.hpp"
#include "tests/fake_port/fake_port.hpp"

namespace psicarve::fake_port {

/// One pulse of an axis, as an enabled or disabled driver would see it.
struct Pulse {
    std::uint8_t axis;
    bool is_positive;
    friend bool operator==(const Pulse&, const Pulse&) = default;
};

/// The test's side of a fake port: device file and state in `folder`, wired as the default pin map is, with
/// the machine of `profile` on it, its axes a few pulses off their sensors.
class FakePortFile {
public:
    FakePortFile(const std::string& folder, const Profile& profile);
    ~FakePortFile();
    FakePortFile(const FakePortFile&) = delete;
    FakePortFile& operator=(const FakePortFile&) = delete;

    /// Another machine on the cable, its axes a few pulses off their sensors.
    void stand(const Profile& profile);

    State& state() noexcept { return *state_; }
    const std::string& device() const noexcept { return device_; }

    /// While it lives, programs that the test starts find the port at device().
    class Preload {
    public:
        explicit Preload(const FakePortFile& port);
        ~Preload();
        Preload(const Preload&) = delete;
        Preload& operator=(const Preload&) = delete;

    private:
        std::optional<std::string> asan_options_;  ///< before
    };

    std::vector<Write> writes() const;

private:
    std::string device_;
    std::string state_path_;
    State* state_ = nullptr;
};

/// Rising step edges with the direction that stood then, in the order of the writes; those of one write by
/// axis.
std::vector<Pulse> pulses_of(const std::vector<Write>& writes, const Profile& profile);
/// Rising step edges from word to word, added to `pulses`.
void add_pulses(std::uint32_t before, std::uint32_t now, std::vector<Pulse>& pulses);
/// The outputs that the registers show after each write.
std::vector<std::uint32_t> levels_of(const std::vector<Write>& writes, const Profile& profile);

/// Those between the spindle's first start and its stop.
std::vector<Pulse> pulses_with_spindle(const std::vector<std::uint32_t>& levels);
/// The same for every time that it turned while an axis stepped.
std::vector<std::vector<Pulse>> runs_with_spindle(const std::vector<std::uint32_t>& levels);

}  // namespace psicarve::fake_port
