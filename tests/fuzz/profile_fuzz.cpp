// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "shared/profile/pin_map.hpp"
#include "shared/profile/profile.hpp"
#include "tests/fuzz/require.hpp"

// Any text: refused in one line, or a profile that prints, reads back equal and can be worked with.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace psicarve;
    using fuzz::require;
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    const auto profile = parse_profile(text, "f.toml");
    if (!profile) {
        const std::string& message = profile.error().message;
        require(message.starts_with("f.toml:"), "a refusal names file and line");
        require(message.find('\n') == std::string::npos, "a refusal is one line");
        return 0;
    }
    const auto again = parse_profile(profile_to_toml(*profile), "printed");
    require(again && *again == *profile, "what parses prints and reads back equal");
    require(PinMap::from_profile(*profile).has_value(), "an accepted profile has a pin map");
    for (const Axis axis : kAllAxes) {
        const AxisMotion motion = axis_motion(*profile, axis);
        require(motion.travel_min_pulses <= motion.travel_max_pulses, "travel is not empty");
        require(motion.start_stop_pps > 0.0 && motion.start_stop_pps <= motion.speed_pps, "speeds in order");
    }
    require(tick_period_ns(*profile) > 0, "time goes on");
    return 0;
}
