// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/phrase/program_phrase.hpp"

namespace psicarve::session {
namespace {

std::vector<Sentence> of_a_program() {
    return {
        {"line %1 has more than 64 MiB: this is no program in G-code",
         phrase("line %1 has more than 64 MiB: this is no program in G-code")},
        {"line %1: it is not known where %2 begins", phrase("line %1: it is not known where %2 begins")},
        {"the program ends before line %1; begin at an earlier line",
         phrase("the program ends before line %1; begin at an earlier line")},
        {"the program was given up", phrase("the program was given up")},
        {"the program ended before its end, in line %1: somebody stopped it; --from-line goes on",
         phrase("it was stopped in line %1; it can go on from there")},
        {"stopped by the operator", phrase("stopped by the operator")},
        {"emergency stop by the operator", phrase("emergency stop by the operator")},
        {"the work offsets have been changed since it was read; decode it again",
         phrase("the work offsets have been changed since it was read; decode it again")},
        {"another process has the work offsets, as the one that runs a program has; wait for its end, or "
         "psicarve stop",
         phrase("another process has the work offsets, as the one that runs a program has; wait for its end, "
                "or stop it")},
        {"the spindle is on; for a dry run switch it off: psicarve spindle off",
         phrase("the spindle is on; for a dry run switch it off")},
        {"the machine was moved or its spindle switched meanwhile; nothing was begun, give the command again",
         phrase("the machine was moved or its spindle switched meanwhile; nothing was begun, start it "
                "again")},
        {"the core has another profile than %1; name the one that it was started with: --profile FILE",
         phrase("the core has another profile than %1; open the one that it was started with")},
        {"r2 follows r1 (profile: gcode.second_head), and they stand at different radii; bring them to one "
         "radius: psicarve move",
         phrase("R2 follows R1 (profile: gcode.second_head), and they stand at different radii; bring them "
                "to one radius")},
        {"%1: not found beside psicarve-hmi nor in PATH; install it there",
         phrase("%1: not found beside psicarve-hmi nor in PATH; install it there")},
        {"%1: work offsets cannot be kept: %2", phrase("%1: work offsets cannot be kept: %2")},
    };
}

}  // namespace

std::optional<Phrase> program_error_phrase(const std::string& message) {
    return phrase_for(of_a_program(), message);
}

std::vector<Sentence> program_file_refusals() {
    return {
        {"is a folder; name a program", phrase("is a folder; choose a program")},
        {"is no regular file, and is read twice; give it as standard input: -",
         phrase("is no regular file, and is read twice")},
        {"has been changed while it is run; what was read of it before is run",
         phrase("has been changed while it is run; what was read of it before is run")},
        {"these work offsets cannot be kept", phrase("these work offsets cannot be kept")},
        {"may not be read by this user; let the machine's group read it, or name another folder: "
         "$PSICARVE_STATE",
         phrase("may not be read by this user; let the machine's group read it, or name another folder: "
                "$PSICARVE_STATE")},
    };
}

}  // namespace psicarve::session
