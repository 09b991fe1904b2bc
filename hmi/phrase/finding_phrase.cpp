// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/phrase/finding_phrase.hpp"

#include <vector>

#include "hmi/phrase/sentence.hpp"

namespace psicarve::session {
namespace {

/// Those that begin with a name or number last: they fit much.
std::vector<Phrase> said() {
    return {
        phrase("real-time scheduling"),
        phrase("allowed by CAP_SYS_NICE"),
        phrase("priority up to %1 only, the tick has %2"),
        phrase("not allowed"),
        phrase("priority up to %1"),
        phrase("any program may keep the tick waiting; a real machine is refused"),
        phrase("locked memory"),
        phrase("allowed by CAP_IPC_LOCK"),
        phrase("unlimited"),
        phrase("at most %1 KiB"),
        phrase("a page that was taken away stops the tick until it is back; a real machine is refused"),
        phrase("processor sleep"),
        phrase("processors that sleep deeply wake up late"),
        phrase("start the kernel with processor.max_cstate=1, or one that has that device"),
        phrase("can be kept shallow"),
        phrase("kernel"),
        phrase("the kernel itself keeps the tick waiting, at times for milliseconds; they are skipped and "
               "counted"),
        phrase("install a real-time kernel: apt install linux-image-rt-amd64"),
        phrase("processor of the tick"),
        phrase("isolated: %1; the tick takes %2"),
        phrase("none is kept free"),
        phrase("other programs and interrupts run where the tick does"),
        phrase("start the kernel with isolcpus=N nohz_full=N rcu_nocbs=N, N the last processor"),
        phrase("processor speed"),
        phrase("not changed by the kernel"),
        phrase("performance"),
        phrase("a processor that first speeds up makes ticks late"),
        phrase("cpupower frequency-set --governor performance (package linux-cpupower)"),
        phrase("clock"),
        phrase("unknown"),
        phrase("reading it takes about a microsecond, several times a tick"),
        phrase("see in the kernel's messages why the tsc is not trusted; often the firmware is to blame"),
        phrase("swap"),
        phrase("none"),
        phrase("the core's memory is locked, but a computer that swaps is late with everything else"),
        phrase("swapoff --all while carving, or more memory"),
        phrase("computer"),
        phrase("no virtual machine"),
        phrase("a virtual machine"),
        phrase("its host takes the processor away when it likes, and nothing here can prevent that"),
        phrase("drive a real machine from a real computer"),
        phrase("shared memory"),
        phrase("the largest job takes %1, two may be there"),
        phrase("the largest job takes %1"),
        phrase("mount a tmpfs there"),
        phrase("mount -o remount,size=1G /dev/shm, or psicarve-rtcore --capacity for smaller jobs"),
        phrase("held by %1"),
        phrase("two programs on one port move motors by accident"),
        phrase("rmmod lp, and keep it out: a line \"blacklist lp\" in /etc/modprobe.d"),
        phrase("end the program that holds it; psicarve status shows a core"),
        phrase("may not be written"),
        phrase("the core cannot drive it"),
        phrase("be in the group that owns it: adduser USER %1, and a new login"),
        phrase("raw addresses"),
        phrase("allowed by CAP_SYS_RAWIO"),
        phrase("no right to addresses; --port ppdev:/dev/parport0 needs no such right"),
        phrase("no right to addresses"),
        phrase("run with CAP_SYS_RAWIO, or use --port ppdev:/dev/parport0"),
        phrase("this kernel lets nobody at addresses: it is locked down (Secure Boot), or this is a "
               "container; --port ppdev:/dev/parport0 needs no such right"),
        phrase("this kernel lets nobody at addresses: it is locked down (Secure Boot), or this is a "
               "container"),
        phrase("this kernel lets nobody at addresses; --port ppdev:/dev/parport0 needs no such right"),
        phrase("this kernel lets nobody at addresses"),
        phrase("--port io:ADDRESS is refused"),
        phrase("use --port ppdev:/dev/parport0"),
        phrase("free"),
        phrase("parallel port"),
        phrase("the kernel has one, but /dev/parport0 is not there"),
        phrase("only the simulated machine can be driven"),
        phrase("only --port io:ADDRESS can drive a machine"),
        phrase("no core has it; one that is started says whether a port is there"),
        phrase("modprobe ppdev"),
        phrase("fit a parallel port; modprobe parport_pc ppdev"),
        phrase("module lp"),
        phrase("loaded"),
        phrase("the printer driver may take the port"),
        phrase("%1 is not there"),
        phrase("%1 may not be written"),
        phrase("%1, PREEMPT_RT"),
        phrase("%1, not PREEMPT_RT"),
        phrase("%1 in use"),
        phrase("%1 free in /dev/shm"),
    };
}

std::vector<Sentence> sentences() {
    std::vector<Sentence> all;
    for (const Phrase& one : said()) all.push_back({one.english, one});
    return all;
}

}  // namespace

Phrase finding_phrase(const std::string& text) {
    if (text.empty()) return {};
    return phrase_for(sentences(), text).value_or(phrase("%1", text));
}

}  // namespace psicarve::session
