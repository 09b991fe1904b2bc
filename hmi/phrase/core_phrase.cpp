// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/phrase/core_phrase.hpp"

#include <algorithm>
#include <string_view>
#include <vector>

#include "hmi/phrase/axis_letter.hpp"
#include "hmi/phrase/sentence.hpp"
#include "shared/machine/command.hpp"

namespace psicarve::session {
namespace {

std::vector<Sentence> remedies() {
    return {{"home first", phrase("home first")},
            {"start first", phrase("start first")},
            {"start interpolation, or stop", phrase("start, or stop")},
            {"resume, or stop", phrase("resume, or stop")},
            {"reset the alarm first", phrase("reset the alarm first")},
            {"wait, or stop", phrase("wait, or stop")}};
}

std::vector<Sentence> refusals() {
    return {
        {"there is no alarm", phrase("there is no alarm")},
        {"only with the drives off; drives-off first, positions are lost then",
         phrase("only with the drives off")},
        {"an output is being tested; end the test first",
         phrase("an output is being tested; end the test first")},
        {"no job is published; publish one first", phrase("no job is published; publish one first")},
        {"the machine is not homed; home first", phrase("the machine is not homed; home first")},
        {"still tripped: %1; release it or back off", phrase("still tripped: %1; release it or back off")},
        {"a switch was tripped until just now; try again",
         phrase("a switch was tripped until just now; try again")},
        {"the axis' sensor is not tripped; nothing to back off from",
         phrase("the switch of the axis is open; there is nothing to back off from")},
        {"the axis has no sensor", phrase("the axis has no sensor")},
        {"the port does not answer: switch the machine off by its own switch, see to card and driver, then "
         "reset the alarm again",
         phrase("the port does not answer: switch the machine off by its own switch")},
        {"the guard process ended; start the core again",
         phrase("the guard process ended; start the core again")},
        {"a published job is being looked at; start once it is accepted",
         phrase("a published job is being looked at; start once it is accepted")},
        {"the port has failed; reset the alarm, then home",
         phrase("the port has failed; reset the alarm, then home")},
        {"a stop came after it; ask again", phrase("a stop came after it; ask again")},
        {"%1 would bring the tips closer than head_clearance_mm, %2",
         phrase("%1 would bring the tips closer than head_clearance_mm, %2")},
        {"%1 would go inside the core radius, %2", phrase("%1 would go inside the core radius, %2")},
        {"%1 has no way left in this direction", phrase("%1 has no way left in this direction")},
        {"%1 cannot count so far", phrase("%1 cannot count so far")},
        {"%1 would leave its travel, %2 to %3", phrase("%1 would leave its travel, %2 to %3")},
        {"the job has not so many layers: %1, and the first is 0",
         phrase("the job has not so many layers, but %1")},
        {"nothing was carved yet; there is nothing to resume", phrase("nothing was carved yet")},
        {"the checkpoint is damaged; look at the piece and give the layer yourself",
         phrase("nobody knows how far it was carved; look at the piece and choose the layer")},
        {"the checkpoint is of another job; publish that one, or give the layer yourself",
         phrase("another job was carved last")},
        {"no layer was finished; start from the beginning", phrase("no layer was finished")},
        {"the job is carved to its end; there is nothing to resume", phrase("the job is carved to its end")},
        {"psi and y after r1 and r2, or with them; home r1 and r2 first",
         phrase("Ψ and Y after R1 and R2, or with them; home R1 and R2 first")},
        {"%1 is not wired to any pin", phrase("%1 is not wired to any pin")},
        {"no core serves segment %1; start one: psicarve-rtcore", phrase("no core serves segment %1")},
        {"no core serves segment %1: start psicarve-rtcore", phrase("no core serves segment %1")},
        {"the core of segment %1 (pid %2) is silent: its heartbeat stands still; is it stopped?",
         phrase("the core of segment %1 (process %2) is silent")},
        {"the core ended before it answered", phrase("the core ended before it answered")},
        {"the core did not answer within %1 ms", phrase("the core did not answer within %1 ms")},
        {"all %1 command slots are in use: wait for the others' commands",
         phrase("too many commands at once; wait for the others")},
        {"a recorded run is being replayed", phrase("a recorded run is being replayed")},
        {"the machine came to rest in state '%1', not %2: somebody stopped it",
         phrase("the machine came to rest (%1), somebody stopped it")},
    };
}

/// "hold: " and the like.
std::string_view without_command(std::string_view reason) {
    for (std::uint32_t k = 0; k < kCommandKindCount; ++k) {
        const std::string_view name = name_of(static_cast<CommandKind>(k));
        if (reason.starts_with(name) && reason.substr(name.size()).starts_with(": "))
            return reason.substr(name.size() + 2);
    }
    return reason;
}

/// "r1" as the window writes it.
void name_axis(std::string& argument) {
    for (const Axis axis : kAllAxes) {
        if (argument == name_of(axis)) argument = axis_letter(axis);
    }
}

std::optional<Phrase> state_refusal(std::string_view text) {
    auto found = phrase_for({{"not while %1; %2", phrase("not while %1; %2")}}, text);
    if (!found) return std::nullopt;
    const std::string remedy = found->arguments.back();
    found->arguments.pop_back();
    found->inner.push_back(phrase_for(remedies(), remedy).value_or(phrase("%1", remedy)));
    return found;
}

/// "alarm: limit of r1; what to do". The banner says what to do.
std::optional<Phrase> alarm_refusal(std::string_view text) {
    auto found = phrase_for(
        {{"alarm: %1 of %2; %3", phrase("alarm: %1, axis %2")}, {"alarm: %1; %2", phrase("alarm: %1")}},
        text);
    if (found) found->arguments.pop_back();
    return found;
}

}  // namespace

Phrase core_phrase(const std::string& reason) {
    const std::string_view text = without_command(reason);
    auto found = state_refusal(text);
    if (!found) found = alarm_refusal(text);
    if (!found) found = phrase_for(refusals(), text);
    if (!found) return phrase("%1", text);
    std::for_each(found->arguments.begin(), found->arguments.end(), name_axis);
    return *found;
}

}  // namespace psicarve::session
