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
    std::uint16_t base = 0;           ///< 0: not by addresses (USB)
    std::uint16_t extended_base = 0;  ///< of the three registers that an ECP port has besides; 0: none
    std::string holder;  ///< the kernel's name of who has claimed it: "lp", "ppdev0"; empty: nobody
};

/// From /proc/sys/dev/parport; `proc` is another place to look for tests. Empty without a driver.
std::vector<KernelPort> kernel_ports(const std::string& proc = "/proc");

/// The three places at which PCs have had parallel ports since the first one.
inline constexpr std::array<std::uint16_t, 3> kClassicBases{0x378, 0x278, 0x3bc};
bool is_classic_base(std::uint16_t base) noexcept;

/// Data, status, control: the addresses from the base on that a port driven by them has, and that are locked.
inline constexpr std::uint16_t kPortRegisters = 3;

/// "0x378"
std::string hex_of(std::uint16_t base);

/// The name (abstract_name.hpp) at which a core listens that drives a port by its addresses; with another
/// place than /dev for the devices, as tests have one, a name of that place alone.
std::string base_lock_name(const std::string& dev, std::uint16_t base);

/// The printer driver, which registers itself with every port and so keeps everybody out who wants one alone.
bool is_lp_loaded(const std::string& proc = "/proc");

/// The name of the group that a file belongs to, its number when it has no name; empty when there is no such
/// file.
std::string group_of(const std::string& path);

/// "psicarve-rtcore (pid 4711)"; its name may be told of any user's process.
std::string process_text(int pid);

/// Processes that have this file open, as far as we may see: "psicarve-rtcore (pid 4711)"; empty: none seen.
std::string processes_with(const std::string& path);

}  // namespace psicarve
