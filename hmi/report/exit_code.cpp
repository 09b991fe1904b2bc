// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/report/exit_code.hpp"

#include <nlohmann/json.hpp>

#include "hmi/report/message_json.hpp"

namespace psicarve::report {
namespace {

const char* name_of(ErrorCode code) noexcept {
    switch (code) {
        case ErrorCode::bad_usage:
            return "bad_usage";
        case ErrorCode::bad_input:
            return "bad_input";
        case ErrorCode::machine_refused:
            return "machine_refused";
        case ErrorCode::no_core:
            return "no_core";
        case ErrorCode::difference_found:
            return "difference_found";
        case ErrorCode::out_of_room:
            return "out_of_room";
        case ErrorCode::timed_out:
            return "timed_out";
        case ErrorCode::cancelled:
            return "cancelled";
    }
    return "unknown";
}

}  // namespace

int exit_code_of(ErrorCode code) noexcept {
    switch (code) {
        case ErrorCode::bad_usage:
            return kExitUsage;
        case ErrorCode::bad_input:
        case ErrorCode::out_of_room:
            return kExitBadInput;
        case ErrorCode::machine_refused:
        case ErrorCode::cancelled:
            return kExitMachine;
        case ErrorCode::no_core:
        case ErrorCode::timed_out:
            return kExitNoCore;
        case ErrorCode::difference_found:
            return kExitDifference;
    }
    return kExitUsage;
}

std::string error_json(const Error& error) {
    return error_json(error, exit_code_of(error.code));
}

std::string error_json(const Error& error, int exit_code) {
    // Messages quote file names, which need not be UTF-8: replace what is not, rather than throw.
    nlohmann::ordered_json object{
        {"code", name_of(error.code)}, {"exit_code", exit_code}, {"message", error.message}};
    if (const auto said = message_json(error.said); !said.is_null()) object.update(said);
    return object.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

}  // namespace psicarve::report
