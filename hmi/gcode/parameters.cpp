// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/gcode/parameters.hpp"

#include <algorithm>

namespace psicarve::gcode {
namespace {

bool is_global(std::string_view name) noexcept {
    return name.starts_with('_');
}

bool is_local_number(const ParameterKey& key) noexcept {
    return key.name.empty() && key.number <= kMostArguments;
}

}  // namespace

std::string parameter_name(const ParameterKey& key) {
    return key.name.empty() ? "#" + std::to_string(key.number) : "#<" + key.name + ">";
}

StateAnswer Parameters::answer_of(const ParameterKey& key) const {
    using Given = StateAnswer::Kind;
    if (key.name.empty()) return key.number <= 5000 ? StateAnswer{} : state_.numbered(key.number);
    if (!is_global(key.name)) return {};
    if (key.name == "_value") return {Given::value, returned_, true};
    if (key.name == "_value_returned") return {Given::value, has_returned_ ? 1.0 : 0.0, true};
    if (key.name == "_call_level") return {Given::value, static_cast<double>(call_depth()), true};
    return state_.named(key.name);
}

const Parameters::Names& Parameters::names_of(std::string_view name) const {
    return is_global(name) ? globals_ : locals_.back().named;
}

std::optional<ParameterFault> Parameters::read(const ParameterKey& key, double& value) {
    const StateAnswer answer = answer_of(key);
    if (answer.kind == StateAnswer::Kind::not_read)
        return ParameterFault{ProblemCode::not_read,
                              phrase("%1 tells of what this machine does not have", parameter_name(key))};
    if (answer.kind == StateAnswer::Kind::value) {
        if (!answer.is_certain) doubt();
        value = answer.value;
        return std::nullopt;
    }
    if (key.name.empty()) {
        value = is_local_number(key) ? locals_.back().numbered[key.number - 1] : numbered_[key.number];
        return std::nullopt;
    }
    const Names& names = names_of(key.name);
    const auto found = names.find(key.name);
    if (found == names.end())
        return ParameterFault{ProblemCode::parameter_unset, phrase("%1 has no value", parameter_name(key))};
    value = found->second;
    return std::nullopt;
}

bool Parameters::exists(const ParameterKey& key) const {
    if (key.name.empty()) return true;
    if (answer_of(key).kind == StateAnswer::Kind::value) return true;
    return names_of(key.name).contains(key.name);
}

std::optional<ParameterFault> Parameters::judge_write(const ParameterKey& key) const {
    if (answer_of(key).kind == StateAnswer::Kind::none) return std::nullopt;
    return ParameterFault{ProblemCode::parameter_kept, phrase("%1 can only be read", parameter_name(key))};
}

std::optional<ParameterFault> Parameters::set(const Planned& planned) {
    const ParameterKey& key = planned.key;
    if (key.name.empty()) {
        (is_local_number(key) ? locals_.back().numbered[key.number - 1] : numbered_[key.number]) =
            planned.value;
        return std::nullopt;
    }
    Names& names = is_global(key.name) ? globals_ : locals_.back().named;
    const auto found = names.find(key.name);
    if (found != names.end()) {
        found->second = planned.value;
        return std::nullopt;
    }
    if (name_count_ >= kMostNames)
        return ParameterFault{ProblemCode::parameter_many, phrase("more than 10000 named parameters")};
    ++name_count_;
    names.emplace(key.name, planned.value);
    return std::nullopt;
}

std::optional<ParameterFault> Parameters::apply() {
    std::optional<ParameterFault> fault;
    for (const Planned& planned : planned_)
        if (!fault) fault = set(planned);
    planned_.clear();
    return fault;
}

void Parameters::enter_call(std::span<const double> arguments) {
    Locals& entered = locals_.emplace_back();
    std::copy(arguments.begin(), arguments.end(), entered.numbered.begin());
    returned_ = 0.0;
    has_returned_ = false;
}

void Parameters::enter_shared() {
    locals_.push_back({locals_.back().numbered, {}});
}

void Parameters::leave_shared() {
    locals_[locals_.size() - 2].numbered = locals_.back().numbered;
    name_count_ -= locals_.back().named.size();
    locals_.pop_back();
}

void Parameters::leave_call(std::optional<double> returned) {
    name_count_ -= locals_.back().named.size();
    locals_.pop_back();
    returned_ = returned.value_or(0.0);
    has_returned_ = returned.has_value();
}

}  // namespace psicarve::gcode
