// SPDX-License-Identifier: GPL-3.0-or-later
#include "shared/machine/signal.hpp"

namespace psicarve {
namespace {

constexpr std::array<std::string_view, kAxisCount> kAxisNames{"r1", "r2", "psi", "y"};

constexpr std::array<std::string_view, kSignalCount> kSignalNames{
    "r1_step",   "r2_step",   "psi_step",   "y_step",   "r1_dir",   "r2_dir",   "psi_dir",  "y_dir",
    "r1_enable", "r2_enable", "psi_enable", "y_enable", "spindle",  "r1_limit", "r2_limit", "psi_index",
    "y_limit",   "estop",     "mist",       "flood",    "output_0", "output_1", "output_2", "output_3"};

}  // namespace

std::string_view name_of(Axis axis) noexcept {
    return kAxisNames[index_of(axis)];
}

std::optional<Axis> axis_from_name(std::string_view name) noexcept {
    for (const Axis axis : kAllAxes) {
        if (name_of(axis) == name) return axis;
    }
    return std::nullopt;
}

std::string_view name_of(Signal signal) noexcept {
    return signal == Signal::charge_pump ? "charge_pump" : kSignalNames[index_of(signal)];
}

std::optional<Signal> signal_from_name(std::string_view name) noexcept {
    for (std::size_t i = 0; i < kSignalCount; ++i) {
        if (kSignalNames[i] == name) return static_cast<Signal>(i);
    }
    return std::nullopt;
}

}  // namespace psicarve
