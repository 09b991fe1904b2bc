# SPDX-License-Identifier: GPL-3.0-or-later
"""What a systemd unit's sandbox lets a program do, without systemd running: the same rules, put into the kernel by
libseccomp as systemd itself does.

System calls that the unit's SystemCallFilter refuses are refused with its own error, and their names are kept
(Sandbox.refused). Whatever else the unit forbids by a call's arguments (memory that can be written and executed,
namespaces, set-uid files) ends the process at once. Capabilities, limits and a file tree that cannot be written are
the unit's, too, as far as the user who runs this has the right to give them away; Sandbox.left_out says what is not.
"""

import ctypes
import errno
import functools
import os
import re
import resource
import select
import socket
import subprocess
import threading

KILL, NOTIFY, ALLOW = 0x80000000, 0x7FC00000, 0x7FFF0000
NOT_EQUAL, MASKED_EQUAL = 1, 7
PROT_WRITE, PROT_EXEC, SHM_EXEC = 2, 4, 0o100000
SET_ID_BITS = (0o4000, 0o2000)
NAMESPACES = (0x00020000, 0x02000000, 0x04000000, 0x08000000, 0x10000000, 0x20000000, 0x40000000)
CLONE_NEWNS, MS_BIND, MS_REC, MS_PRIVATE = 0x00020000, 4096, 16384, 1 << 18
SYS_MOUNT_SETATTR, AT_FDCWD, AT_RECURSIVE, MOUNT_ATTR_RDONLY = 442, -100, 0x8000, 1
PR_CAPBSET_DROP = 24

# Groups of calls that a setting takes away; none of them may come back by the filter.
PROTECTED = {"ProtectClock": ["@clock"], "ProtectKernelModules": ["@module"], "ProtectKernelLogs": ["syslog"],
             "ProtectHostname": ["sethostname", "setdomainname"]}
# What a process without systemd cannot be given, and what is no restriction of it.
ELSEWHERE = {"ExecStart", "ExitType", "KillMode", "TimeoutStopSec", "Restart", "RestartSec", "RestartPreventExitStatus",
             "User", "Group", "OOMScoreAdjust", "DevicePolicy", "DeviceAllow", "ProtectHome", "PrivateTmp",
             "PrivateMounts", "PrivateNetwork", "IPAddressDeny", "ProtectControlGroups", "ProtectKernelTunables",
             "RemoveIPC", "SystemCallArchitectures"}
IMITATED = {"SystemCallFilter", "SystemCallErrorNumber", "MemoryDenyWriteExecute", "RestrictNamespaces",
            "RestrictSUIDSGID", "RestrictAddressFamilies", "LockPersonality", "NoNewPrivileges", "UMask",
            "CapabilityBoundingSet", "LimitRTPRIO", "LimitMEMLOCK", "ProtectSystem", "ReadWritePaths", "StateDirectory",
            *PROTECTED}

libc = ctypes.CDLL(None, use_errno=True)
seccomp = ctypes.CDLL("libseccomp.so.2")
seccomp.seccomp_init.restype = ctypes.c_void_p
seccomp.seccomp_syscall_resolve_num_arch.restype = ctypes.c_char_p


class Comparison(ctypes.Structure):
    _fields_ = [("arg", ctypes.c_uint), ("op", ctypes.c_int), ("a", ctypes.c_uint64), ("b", ctypes.c_uint64)]


class Notice(ctypes.Structure):
    _fields_ = [("id", ctypes.c_uint64), ("pid", ctypes.c_uint32), ("flags", ctypes.c_uint32), ("nr", ctypes.c_int32),
                ("arch", ctypes.c_uint32), ("ip", ctypes.c_uint64), ("args", ctypes.c_uint64 * 6)]


class Answer(ctypes.Structure):
    _fields_ = [("id", ctypes.c_uint64), ("val", ctypes.c_int64), ("error", ctypes.c_int32), ("flags", ctypes.c_uint32)]


def refuse_with(error):
    return 0x00050000 | error


def settings_of(unit):
    """Of its section [Service]: name -> values."""
    settings = {}
    with open(unit, encoding="utf-8") as file:
        section = file.read().split("[Service]")[1].split("\n[")[0]
    for name, value in re.findall(r"(?m)^([A-Za-z]+)=(.*)$", section):
        settings.setdefault(name, []).append(value.strip())
    unknown = settings.keys() - IMITATED - ELSEWHERE
    if unknown:
        raise SystemExit(f"{unit}: no test knows {', '.join(sorted(unknown))}")
    return settings


@functools.cache
def calls_in(name):
    """A call, or all those of a group, by systemd's own lists."""
    if not name.startswith("@"):
        return {name}
    listed = subprocess.run(["systemd-analyze", "syscall-filter", name], capture_output=True, text=True, check=True)
    members = [line.strip() for line in listed.stdout.splitlines() if line.startswith("    ")]
    return {call for member in members if not member.startswith("#") for call in calls_in(member)}


def allowed_calls(settings):
    allowed = calls_in("@default")
    lines = settings["SystemCallFilter"]
    if lines[0].startswith("~"):
        raise SystemExit("SystemCallFilter begins with what is forbidden: all else would be allowed")
    for line in lines:
        named = {call for name in line.lstrip("~").split() for call in calls_in(name)}
        allowed = allowed - named if line.startswith("~") else allowed | named
    for setting, names in PROTECTED.items():
        if settings.get(setting) == ["yes"]:
            allowed -= {call for name in names for call in calls_in(name)}
    return allowed


class Filter:
    def __init__(self, default):
        self.context = ctypes.c_void_p(seccomp.seccomp_init(ctypes.c_uint32(default)))
        if not self.context:
            raise SystemExit("libseccomp makes no filter here")

    def add(self, action, call, *comparisons):
        """What this processor's kernel does not have needs no rule. A comparison: argument, operator, mask, value."""
        number = seccomp.seccomp_syscall_resolve_name(call.encode())
        if number < 0:
            return
        array = (Comparison * max(1, len(comparisons)))(*[Comparison(*one) for one in comparisons])
        failed = seccomp.seccomp_rule_add_array(self.context, ctypes.c_uint32(action), number, len(comparisons), array)
        if failed:
            raise SystemExit(f"no rule for {call}: {os.strerror(-failed)}")

    def load(self):
        failed = seccomp.seccomp_load(self.context)
        if failed:
            raise OSError(-failed, "seccomp_load")


def arguments_filter(settings):
    rules = Filter(ALLOW)

    def has_bits(argument, bits):
        return (argument, MASKED_EQUAL, bits, bits)

    if settings.get("MemoryDenyWriteExecute") == ["yes"]:
        rules.add(KILL, "mmap", has_bits(2, PROT_WRITE | PROT_EXEC))
        rules.add(KILL, "mprotect", has_bits(2, PROT_EXEC))
        rules.add(KILL, "pkey_mprotect", has_bits(2, PROT_EXEC))
        rules.add(KILL, "shmat", has_bits(2, SHM_EXEC))
    if settings.get("RestrictNamespaces") == ["yes"]:
        for bit in NAMESPACES:
            rules.add(KILL, "unshare", has_bits(0, bit))
            rules.add(KILL, "clone", has_bits(0, bit))
        rules.add(KILL, "setns")
        # Its arguments lie in memory, where no filter looks; the C library then takes clone.
        rules.add(refuse_with(errno.ENOSYS), "clone3")
    if settings.get("RestrictSUIDSGID") == ["yes"]:
        modes = {"chmod": 1, "fchmod": 1, "fchmodat": 2, "mkdir": 1, "mkdirat": 2, "mknod": 1, "mknodat": 2}
        for call, mode in modes.items():
            for bit in SET_ID_BITS:
                rules.add(KILL, call, has_bits(mode, bit))
        for call, flags in {"open": 1, "openat": 2}.items():
            for bit in SET_ID_BITS:
                rules.add(KILL, call, has_bits(flags, os.O_CREAT), has_bits(flags + 1, bit))
    if settings.get("LockPersonality") == ["yes"]:
        rules.add(KILL, "personality", (0, NOT_EQUAL, libc.personality(0xFFFFFFFF), 0))
    if settings.get("RestrictAddressFamilies") == ["none"]:
        # Not the end: the C library asks daemons for a group's name, and goes on without them.
        rules.add(refuse_with(errno.EAFNOSUPPORT), "socket")
    return rules


class Sandbox:
    """Starts programs as a unit would."""

    def __init__(self, unit, state):
        """`state`: a folder, which stands for the one that StateDirectory makes."""
        self.settings = settings_of(unit)
        self.state = state if "StateDirectory" in self.settings else ""
        self.refused = set()
        self.left_out = set()
        self.error = getattr(errno, self.settings["SystemCallErrorNumber"][0])
        self.allowed = allowed_calls(self.settings)

    def start(self, words, **popen):
        calls = Filter(NOTIFY)
        for call in self.allowed:
            calls.add(ALLOW, call)
        arguments = arguments_filter(self.settings)
        ours, theirs = socket.socketpair()
        ours.settimeout(60)

        def confine():
            left_out = self.give_rights_away()
            os.umask(int(self.settings["UMask"][0], 8))
            arguments.load()
            calls.load()
            listener = seccomp.seccomp_notify_fd(calls.context)
            socket.send_fds(theirs, [" ".join(left_out).encode() or b" "], [listener])

        try:
            process = subprocess.Popen(words, preexec_fn=confine, **popen)
        except subprocess.SubprocessError as error:
            raise SystemExit("this kernel, or the container round us, lets nobody confine a process and hear of its "
                             f"calls (seccomp user notification): {error}") from error
        said, descriptors, _, _ = socket.recv_fds(ours, 1000, 1)
        self.left_out |= set(said.decode().split())
        threading.Thread(target=self.answer, args=(descriptors[0], process), daemon=True).start()
        return process

    def answer(self, listener, process):
        poll = select.poll()
        poll.register(listener, select.POLLIN)
        while process.returncode is None:
            if not any(event & select.POLLIN for _, event in poll.poll(100)):
                continue
            notice = Notice()
            if seccomp.seccomp_notify_receive(listener, ctypes.byref(notice)) != 0:
                continue
            name = seccomp.seccomp_syscall_resolve_num_arch(notice.arch, notice.nr)
            self.refused.add(name.decode() if name else str(notice.nr))
            answer = Answer(id=notice.id, error=-self.error)
            seccomp.seccomp_notify_respond(listener, ctypes.byref(answer))
        os.close(listener)

    def give_rights_away(self):
        """In the process to be. Returns the settings that it has not got."""
        left_out = []
        limits = {"LimitRTPRIO": resource.RLIMIT_RTPRIO, "LimitMEMLOCK": resource.RLIMIT_MEMLOCK}
        for name, limit in limits.items():
            value = self.settings[name][0]
            wanted = resource.RLIM_INFINITY if value == "infinity" else int(value)
            try:
                resource.setrlimit(limit, (wanted, wanted))
            except (OSError, ValueError):
                left_out.append(name)
        if not self.has_read_only_tree():
            left_out.append("ProtectSystem")
        if self.settings["CapabilityBoundingSet"] == [""]:
            for capability in range(64):
                if libc.prctl(PR_CAPBSET_DROP, capability, 0, 0, 0) != 0 and ctypes.get_errno() == errno.EPERM:
                    left_out.append("CapabilityBoundingSet")
                    break
        return left_out

    def has_read_only_tree(self):
        if self.settings["ProtectSystem"] != ["strict"] or libc.unshare(CLONE_NEWNS) != 0:
            return False

        def change(path, to_set, to_clear):
            attributes = (ctypes.c_uint64 * 4)(to_set, to_clear, 0, 0)
            return libc.syscall(SYS_MOUNT_SETATTR, AT_FDCWD, path, AT_RECURSIVE, attributes, 32) == 0

        writable = [path.encode() for path in self.settings["ReadWritePaths"][0].split()]
        writable += [self.state.encode()] if self.state else []
        done = libc.mount(None, b"/", None, MS_REC | MS_PRIVATE, None) == 0
        for path in writable:
            done = done and libc.mount(path, path, None, MS_BIND | MS_REC, None) == 0
        if not done or not change(b"/", MOUNT_ATTR_RDONLY, 0):
            return False
        if not all(change(path, 0, MOUNT_ATTR_RDONLY) for path in writable):
            raise OSError(ctypes.get_errno(), "no path of the unit's can be made writable again")
        return True
