# SPDX-License-Identifier: GPL-3.0-or-later
# cmake -DUNIT= -DRULES= -DCORE= -P this: the options in the unit's ExecStart are the core's own. With the virtual clock, which a
# real port refuses when all else is right, so that nothing is opened.
cmake_minimum_required(VERSION 3.25)
file(STRINGS "${UNIT}" lines REGEX "^ExecStart=")
list(LENGTH lines count)
if(NOT count EQUAL 1)
    message(FATAL_ERROR "${UNIT} has ${count} lines ExecStart=")
endif()
if(NOT lines MATCHES "^ExecStart=(/[^ ]*/psicarve-rtcore) (.*)$")
    message(FATAL_ERROR "${UNIT} starts no core: ${lines}")
endif()
separate_arguments(arguments UNIX_COMMAND "${CMAKE_MATCH_2}")
execute_process(COMMAND "${CORE}" ${arguments} --clock virtual RESULT_VARIABLE result ERROR_VARIABLE said)
if(NOT result EQUAL 2 OR NOT said MATCHES "a real machine keeps real time")
    message(FATAL_ERROR "${CORE} ${arguments}: ${result}: ${said}")
endif()
# A core whose guard died has to live until its spindle is off, and hears of an end by itself.
file(STRINGS "${UNIT}" settings REGEX "^[A-Za-z]+=")
foreach(setting "ExitType=cgroup" "KillMode=control-group")
    if(NOT "${setting}" IN_LIST settings)
        message(FATAL_ERROR "${UNIT} lacks ${setting}")
    endif()
endforeach()
# Who starts it on a computer without the port is told so.
file(STRINGS "${UNIT}" conditions REGEX "^Condition")
if(conditions)
    message(FATAL_ERROR "${UNIT} may be skipped without a word: ${conditions}")
endif()
# The rule gives the port to the group that the service has.
file(STRINGS "${RULES}" rules REGEX "SUBSYSTEM==\"ppdev\"")
if(NOT rules MATCHES "GROUP=\"psicarve\"" OR NOT "Group=psicarve" IN_LIST settings)
    message(FATAL_ERROR "${RULES}: ${rules}: another group than that of ${UNIT}")
endif()
# systemd's own opinion; neither asks for a systemd that runs.
find_program(systemd_analyze systemd-analyze)
if(NOT systemd_analyze)
    message(FATAL_ERROR "no systemd-analyze here (package systemd): nobody looks at the unit's other lines")
endif()
string(REGEX REPLACE "/[^/]*$" "" folder "${UNIT}")
file(READ "${UNIT}" text)
# Installed or not, there is a program to start.
string(REGEX REPLACE "ExecStart=[^ ]*" "ExecStart=${CORE}" text "${text}")
set(copy "${folder}/verify/psicarve-rtcore.service")
file(WRITE "${copy}" "${text}")
execute_process(COMMAND "${systemd_analyze}" verify "${copy}" RESULT_VARIABLE result ERROR_VARIABLE said)
if(NOT result EQUAL 0 OR NOT said STREQUAL "")
    message(FATAL_ERROR "systemd-analyze verify: ${result}: ${said}")
endif()
# Exposure in tenths, of 100. What is left: a port, real-time rights, the processes of those who send commands, files
# given to a group.
set(most_exposure 10)
execute_process(COMMAND "${systemd_analyze}" security --no-pager --offline=true --threshold=${most_exposure} "${copy}"
    RESULT_VARIABLE result OUTPUT_VARIABLE said ERROR_VARIABLE said)
if(NOT result EQUAL 0)
    string(REGEX MATCHALL "[^\n]*(✗|exposure)[^\n]*" open "${said}")
    list(JOIN open "\n" open)
    message(FATAL_ERROR "systemd-analyze security: more than ${most_exposure} tenths\n${open}")
endif()
