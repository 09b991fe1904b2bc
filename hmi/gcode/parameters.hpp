// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "hmi/gcode/problem.hpp"
#include "hmi/gcode/program_state.hpp"

namespace psicarve::gcode {

inline constexpr std::uint32_t kLastParameter = 5601;
inline constexpr std::size_t kMostArguments = 30;
inline constexpr std::size_t kMostNames = 10'000;
inline constexpr std::size_t kMostCalls = 100;

/// A parameter by its number, or by its name where that is not empty.
struct ParameterKey {
    std::uint32_t number = 0;
    std::string name;  ///< in small letters, without blanks
};

/// Why a parameter cannot be read or set.
struct ParameterFault {
    ProblemCode code = ProblemCode::parameter_range;
    Phrase what;
};

/// The parameters of a program. #1 to #30 and names that do not begin with _ are each call's own; the memory
/// that names take is bounded.
class Parameters {
public:
    /// The state outlives the parameters.
    explicit Parameters(const ProgramState& state) : state_(state), locals_(1) {}

    std::optional<ParameterFault> read(const ParameterKey& key, double& value);
    bool exists(const ParameterKey& key) const;
    std::optional<ParameterFault> judge_write(const ParameterKey& key) const;

    /// Assignments take effect together, when their block is read: apply().
    void plan(const ParameterKey& key, double value) { planned_.push_back({key, value}); }
    void drop_plans() noexcept { planned_.clear(); }
    std::optional<ParameterFault> apply();

    std::size_t call_depth() const noexcept { return locals_.size() - 1; }
    /// Requires call_depth() < kMostCalls and at most kMostArguments.
    void enter_call(std::span<const double> arguments);
    /// Nothing: the subroutine returns no value.
    void leave_call(std::optional<double> returned);

    /// As M98 does: #1 to #30 stay those of the caller, and are it again.
    void enter_shared();
    void leave_shared();

    /// Values are no longer those that the program means: a block was wrong, or a place is not known.
    void doubt() noexcept { is_doubtful_ = true; }
    bool is_doubtful() const noexcept { return is_doubtful_; }

private:
    using Names = std::map<std::string, double, std::less<>>;
    struct Locals {
        std::array<double, kMostArguments> numbered{};
        Names named;
    };
    struct Planned {
        ParameterKey key;
        double value = 0.0;
    };

    StateAnswer answer_of(const ParameterKey& key) const;
    const Names& names_of(std::string_view name) const;
    std::optional<ParameterFault> set(const Planned& planned);

    const ProgramState& state_;
    std::vector<Locals> locals_;
    Names globals_;
    std::size_t name_count_ = 0;
    std::array<double, kLastParameter + 1> numbered_{};
    std::vector<Planned> planned_;
    double returned_ = 0.0;
    bool has_returned_ = false;
    bool is_doubtful_ = false;
};

/// "#5", "#<name>"
std::string parameter_name(const ParameterKey& key);

}  // namespace psicarve::gcode
