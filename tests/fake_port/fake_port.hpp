// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>

namespace psicarve::fake_port {

// A parallel port that is not there: a file that a preloaded library (preload.cpp) makes answer like
// /dev/parportN, with a machine of four axes on its cable. This is what library and test share, in a second
// file: the test sets it up and watches, the library plays it.

/// The environment of the program that the library is loaded into.
inline constexpr const char* kDeviceVariable = "PSICARVE_FAKE_PORT_DEVICE";  ///< path that is the port
inline constexpr const char* kStateVariable = "PSICARVE_FAKE_PORT_STATE";    ///< file with a State

enum class Register : std::uint8_t { data, control };

struct Write {
    std::uint64_t time_ns;  ///< CLOCK_MONOTONIC
    Register reg;
    std::uint8_t value;
    std::uint8_t reserved[6];
};

/// A wire by register bit; on an inverted one the bit is the opposite of the pin.
struct Wire {
    Register reg;
    std::uint8_t bit;
    std::uint8_t is_inverted;
};

enum class Sensor : std::uint8_t { none, above, below, index };

/// One axis: it counts every rising step edge of its enabled drive, and its sensor sees the count.
struct FakeAxis {
    Wire step;
    Wire dir;
    Wire enable;
    Sensor sensor;
    std::uint8_t status_bit;
    std::uint8_t is_status_inverted;
    std::atomic<std::int64_t> position_pulses;
    std::int64_t edge_pulses;     ///< above, below: tripped beyond it; index: tripped from it on ...
    std::int64_t index_pulses;    ///< ... for so many
    std::int64_t pulses_per_rev;  ///< index
    std::atomic<std::uint64_t> pulses;
};

inline constexpr std::size_t kMostWrites = std::size_t{1} << 20;

struct State {
    // What the port is like. Set by the test before the program opens it.
    std::atomic<std::uint32_t> modes;      ///< PARPORT_MODE bits
    std::atomic<std::int32_t> open_errno;  ///< open() fails with this
    std::atomic<std::int32_t> claim_errno;
    std::atomic<std::int32_t> direction_errno;  ///< PPDATADIR, which comes after the claim
    // What the test plays meanwhile.
    std::atomic<std::uint32_t> status_flip;       ///< status bits that show the opposite of the truth
    std::atomic<std::uint32_t> status_chatter;    ///< status bits that flip from one read to the next
    std::atomic<std::int64_t> accesses_to_fault;  ///< reads and writes that still go well; negative: all
    std::atomic<std::int64_t> faults;             ///< so many then fail; negative: all
    std::atomic<std::int32_t> fault_errno;
    std::atomic<std::uint32_t> delay_every;    ///< every so many writes one takes effect later ...
    std::atomic<std::uint32_t> delay_ns;       ///< ... by this, as by a host that takes the computer away
    std::atomic<std::uint64_t> flip_at_write;  ///< before this write (counted from 1) status_flip becomes ...
    std::atomic<std::uint64_t> flip_at_pulse;  ///< the same, by the pulses that the axes have taken
    std::atomic<std::uint32_t> flip_to;        ///< ... this; 0: never
    // What has happened.
    std::atomic<std::uint32_t> claimed_by;  ///< pid
    std::atomic<std::uint32_t> excluded_by;
    std::atomic<std::uint32_t> data;
    std::atomic<std::uint32_t> control;
    std::atomic<std::uint64_t> reads;
    std::atomic<std::uint64_t> write_count;
    std::atomic<std::uint64_t> pulse_count;
    std::array<FakeAxis, 4> axes;  ///< r1, r2, psi, y
    std::array<Write, kMostWrites> writes;
};

}  // namespace psicarve::fake_port
