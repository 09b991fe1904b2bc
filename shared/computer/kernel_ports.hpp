// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace psicarve {

/// A parallel port as the kernel lists it.
struct KernelPort {
    std::string name;                 ///< "parport0"
    std::uint16_t base = 0;           ///< 0: the port is not driven by addresses (USB)
    std::uint16_t extended_base = 0;  ///< of the three further registers of an ECP port; 0: none
    std::string holder;               ///< the driver that has claimed it: "lp", "ppdev0"; empty: none
};

/// Reads /proc/sys/dev/parport; tests give another `proc`. Empty without a driver.
std::vector<KernelPort> kernel_ports(const std::string& proc = "/proc");

/// The three places at which PCs have had parallel ports since the first one.
inline constexpr std::array<std::uint16_t, 3> kClassicBases{0x378, 0x278, 0x3bc};
bool is_classic_base(std::uint16_t base) noexcept;

/// Data, status, control: a core that drives a port by its addresses locks these registers from the base on.
inline constexpr std::uint16_t kPortRegisters = 3;

/// "0x378"
std::string hex_of(std::uint16_t base);

/// The name (abstract_name.hpp) at which a core listens that drives a port by its addresses; with another
/// place than /dev for the devices, as tests have one, a name of that place alone.
std::string base_lock_name(const std::string& dev, std::uint16_t base);

/// The printer driver, which registers itself with every port and so keeps out every program that wants one
/// alone.
bool is_lp_loaded(const std::string& proc = "/proc");

/// The name of the group that a file belongs to, or its number when the group has no name; empty when there
/// is no such file.
std::string group_of(const std::string& path);

/// "psicarve-rtcore (pid 4711)". Every user may read the name of every process.
std::string process_text(int pid);

/// Processes that have this file open, of those that this user may see: "psicarve-rtcore (pid 4711)"; empty:
/// none seen.
std::string processes_with(const std::string& path);

}  // namespace psicarve
