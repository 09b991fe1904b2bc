# SPDX-License-Identifier: GPL-3.0-or-later
"""A LinuxCNC machine without hardware or window: X = R1, Y = R2, Z = psi as a linear axis, 1 mm for 1 degree.

Z is linear because LinuxCNC blends corners of linear axes best; a rotary axis would make it slower.
"""

# Runs inside LinuxCNC as its user interface: homes, records, runs the program, reports, ends.
OPERATOR = """#!/usr/bin/python3
import subprocess
import sys
import time

import linuxcnc

command, status = linuxcnc.command(), linuxcnc.stat()


def until(condition, limit_s):
    end_s = time.monotonic() + limit_s
    while time.monotonic() < end_s:
        status.poll()
        if condition():
            return True
        time.sleep(0.01)
    return False


def mode(wanted):
    command.mode(wanted)
    command.wait_complete()


until(lambda: status.estop, 5)
command.state(linuxcnc.STATE_ESTOP_RESET)
command.wait_complete()
command.state(linuxcnc.STATE_ON)
command.wait_complete()
mode(linuxcnc.MODE_MANUAL)
command.teleop_enable(0)
command.wait_complete()
command.home(-1)
if not until(lambda: all(status.homed[:3]), 10):
    sys.exit("not homed")
recorder = subprocess.Popen(["halsampler", "samples.txt"])
mode(linuxcnc.MODE_AUTO)
command.program_open("layer.ngc")
command.wait_complete()
command.auto(linuxcnc.AUTO_RUN, 0)
until(lambda: status.interp_state != linuxcnc.INTERP_IDLE, 5)
finished = until(lambda: status.interp_state == linuxcnc.INTERP_IDLE and status.inpos, {limit_s})
time.sleep(0.2)
recorder.terminate()
recorder.wait()
open("outcome.txt", "w").write("finished" if finished else "not finished")
"""

HAL = """loadrt [KINS]KINEMATICS
loadrt [EMCMOT]EMCMOT servo_period_nsec=[EMCMOT]SERVO_PERIOD num_joints=[KINS]JOINTS
loadrt sampler depth=60000 cfg=fff
addf motion-command-handler servo-thread
addf motion-controller servo-thread
addf sampler.0 servo-thread
net r1 joint.0.motor-pos-cmd joint.0.motor-pos-fb sampler.0.pin.0
net r2 joint.1.motor-pos-cmd joint.1.motor-pos-fb sampler.0.pin.1
net psi joint.2.motor-pos-cmd joint.2.motor-pos-fb sampler.0.pin.2
net enable iocontrol.0.user-enable-out iocontrol.0.emc-enable-in
net prepare iocontrol.0.tool-prepare iocontrol.0.tool-prepared
net change iocontrol.0.tool-change iocontrol.0.tool-changed
"""

INI = """[EMC]
VERSION = 1.1
MACHINE = one-layer
[DISPLAY]
DISPLAY = ./operate.py
[RS274NGC]
PARAMETER_FILE = parameters.var
[TASK]
TASK = milltask
CYCLE_TIME = 0.001
[EMCIO]
EMCIO = io
CYCLE_TIME = 0.1
TOOL_TABLE = tools.tbl
[EMCMOT]
EMCMOT = motmod
COMM_TIMEOUT = 4.0
SERVO_PERIOD = 1000000
[HAL]
HALFILE = machine.hal
[KINS]
KINEMATICS = trivkins coordinates=XYZ
JOINTS = 3
[TRAJ]
COORDINATES = X Y Z
LINEAR_UNITS = mm
ANGULAR_UNITS = degree
MAX_LINEAR_VELOCITY = 10000
MAX_LINEAR_ACCELERATION = 100000
DEFAULT_LINEAR_VELOCITY = 100
ARC_BLEND_ENABLE = 1
ARC_BLEND_OPTIMIZATION_DEPTH = 100
"""


def ini_text(limits):
    """limits: (speed, acceleration) of X, Y, Z."""
    parts = [INI]
    for number, (letter, (speed, accel)) in enumerate(zip("XYZ", limits)):
        bounds = "MIN_LIMIT = -1000000\nMAX_LIMIT = 1000000\n"
        motion = f"MAX_VELOCITY = {speed}\nMAX_ACCELERATION = {accel}\n"
        parts.append(f"[AXIS_{letter}]\n{bounds}{motion}")
        joint = "TYPE = LINEAR\nHOME_SEQUENCE = 0\nFERROR = 10\nMIN_FERROR = 10\n"
        parts.append(f"[JOINT_{number}]\n{joint}{bounds}{motion}")
    return "".join(parts)


def program_text(points, tolerance_mm):
    """To the first point, a rest that marks the beginning, then point after point as fast as the axes can."""
    words = ["X{:.6f} Y{:.6f} Z{:.6f}".format(*point) for point in points]
    head = ["G21 G90 G94 G17 G40 G49 G80", f"G64 P{tolerance_mm}", "F999999", f"G0 {words[0]}", "G4 P0.3"]
    return "\n".join(head + [f"G1 {word}" for word in words[1:]] + ["M2", ""])
