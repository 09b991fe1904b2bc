# SPDX-License-Identifier: GPL-3.0-or-later
# cmake -DROOT=<tree> -P architecture_test.cmake: fails when the tree breaks one of the rules below.
# Each rule has a name in brackets; tests/project/architecture_self_test.cmake breaks them one by one.
cmake_minimum_required(VERSION 3.25)

# [top-level] What may stand at the root; build folders and personal settings are not ours to judge.
set(allowed_top README.md LICENSE CMakeLists.txt CMakePresets.json .clang-format .clang-tidy .gitignore
    .ci .git scripts shared rtcore hmi tests docs examples packaging)
set(ignored_top build out compile_commands.json CMakeUserPresets.json .cache .vscode .idea)

set(max_lines 400)  # [length]

# [real-time] What the tick may not include: it allocates, locks, blocks or talks.
set(banned_in_cycle
    any barrier boost condition_variable deque filesystem format forward_list fstream
    functional future iomanip ios iostream istream latch list locale map memory memory_resource mutex ostream queue
    regex semaphore set shared_mutex sstream stack stdexcept stop_token streambuf string syncstream system_error
    thread toml unordered_map unordered_set valarray vector
    cstdio stdio.h fcntl.h unistd.h pthread.h poll.h semaphore.h)

set_property(GLOBAL PROPERTY violations "")
function(violation rule file text)
    message("[${rule}] ${file}: ${text}")
    set_property(GLOBAL APPEND PROPERTY violations ${rule})
endfunction()

# [rooms] The arrows between folders.
include("${ROOT}/scripts/rooms.cmake")
foreach(entry IN LISTS PSICARVE_ROOMS)
    psicarve_read_room("${entry}" folder needs)
    foreach(needed IN LISTS needs)
        if(NOT DEFINED "arrows_of_${needed}")
            violation(rooms scripts/rooms.cmake "${folder} needs ${needed}, which does not stand before it")
        endif()
    endforeach()
    set("arrows_of_${folder}" "${needs}")
endforeach()

# [rooms] A folder with code is in the table, and includes what the table lets it.
function(check_room file target)
    get_filename_component(folder "${file}" DIRECTORY)
    get_filename_component(included "${target}" DIRECTORY)
    if(NOT file MATCHES "^(shared|rtcore|hmi)/" OR folder MATCHES "^(rtcore|hmi)$" OR included STREQUAL folder)
        return()
    endif()
    if(NOT included IN_LIST "arrows_of_${folder}")
        violation(rooms ${file} "includes ${target}: scripts/rooms.cmake has no arrow from ${folder} to ${included}")
    endif()
endfunction()
function(check_room_of file)
    get_filename_component(folder "${file}" DIRECTORY)
    if(file MATCHES "^(shared|rtcore|hmi)/.*\\.(cpp|hpp)$" AND NOT file MATCHES "^(rtcore|hmi)/[a-z_]+\\.cpp$"
       AND NOT DEFINED "arrows_of_${folder}")
        violation(rooms ${file} "${folder} is not in scripts/rooms.cmake")
    endif()
endfunction()

# The files that the rules are about, as paths from the root.
function(list_files out)
    set(found)
    foreach(folder shared rtcore hmi tests scripts examples .ci packaging)
        file(GLOB_RECURSE files RELATIVE "${ROOT}" "${ROOT}/${folder}/*")
        list(APPEND found ${files})
    endforeach()
    file(GLOB files RELATIVE "${ROOT}" "${ROOT}/CMakeLists.txt")
    list(APPEND found ${files})
    list(FILTER found INCLUDE REGEX
        "(\\.(cpp|hpp|h|c|py|sh|cmake|toml|ui)|/CMakeLists\\.txt|^CMakeLists\\.txt|^\\.ci/run)$")
    list(FILTER found EXCLUDE REGEX "/__pycache__/")
    list(SORT found)
    set(${out} "${found}" PARENT_SCOPE)
endfunction()

# [arrows] hmi -> shared <- rtcore; [qt] widgets in hmi/ui alone; [commands] nothing leans on hmi/cli;
# [real-time]; [root-include].
function(check_include file target quoted)
    string(REGEX MATCH "^[a-z]+" includer "${file}")
    string(REGEX MATCH "^[a-z]+" included "${target}")
    if(quoted AND NOT target MATCHES "^(shared|rtcore|hmi|tests)/")
        violation(root-include ${file} "#include \"${target}\" does not start at the root")
    endif()
    if(NOT quoted AND target MATCHES "^(shared|rtcore|hmi|tests)/")
        violation(root-include ${file} "#include <${target}>: ours are quoted")
    endif()
    if((includer STREQUAL "shared" AND included MATCHES "^(rtcore|hmi|tests)$")
       OR (includer STREQUAL "rtcore" AND included MATCHES "^(hmi|tests)$")
       OR (includer STREQUAL "hmi" AND included MATCHES "^(rtcore|tests)$"))
        violation(arrows ${file} "includes ${target}: the arrows are hmi -> shared <- rtcore")
    endif()
    if(file MATCHES "^hmi/" AND NOT file MATCHES "^hmi/(cli/|psicarve_main\\.cpp)" AND target MATCHES "^hmi/cli/")
        violation(commands ${file} "includes ${target}: what others need, too, does not belong to a command")
    endif()
    if(target MATCHES "^(Qt?[A-Z]|ui_|qcustomplot)" AND NOT file MATCHES
       "^((tests/)?hmi/ui|tests/hmi/x11|tests/bench/window)/")
        violation(qt ${file} "includes ${target}: only hmi/ui knows Qt")
    endif()
    if(file MATCHES "^rtcore/cycle/")
        string(REGEX REPLACE "[/+].*$" "" first "${target}")
        if(first IN_LIST banned_in_cycle OR target MATCHES "^(sys/|Q|linux/)")
            violation(real-time ${file} "includes ${target}: not in the tick")
        endif()
    endif()
endfunction()

function(check_includes file)
    check_room_of("${file}")
    file(STRINGS "${ROOT}/${file}" lines REGEX "^[ \t]*#[ \t]*include[ \t]*[\"<]")
    foreach(line IN LISTS lines)
        string(REGEX MATCH "include[ \t]*([\"<])([^\">]+)" match "${line}")
        string(COMPARE EQUAL "${CMAKE_MATCH_1}" "\"" quoted)
        set(target "${CMAKE_MATCH_2}")
        check_include("${file}" "${target}" ${quoted})
        string(REGEX MATCH "^[a-z]+" side "${file}")
        string(REGEX MATCH "^[a-z]+" other "${target}")
        # An arrow from one side to the other has its own rule.
        if(quoted AND (side STREQUAL other OR other STREQUAL "shared") AND NOT target MATCHES "^hmi/cli/")
            check_room("${file}" "${target}")
        endif()
    endforeach()
endfunction()

# [spdx], [length], [names], [markers]
function(check_text file)
    file(READ "${ROOT}/${file}" text)
    string(REGEX MATCHALL "\n" newlines "${text}")
    list(LENGTH newlines lines)
    if(lines GREATER max_lines)
        violation(length ${file} "${lines} lines, at most ${max_lines}")
    endif()
    string(SUBSTRING "${text}" 0 200 head)
    if(NOT head MATCHES "SPDX-License-Identifier: GPL-3\\.0-or-later")
        violation(spdx ${file} "no licence line at its head")
    endif()
    if(text MATCHES "(TO|FIX)(DO|ME)[^A-Za-z_]")
        violation(markers ${file} "holds the marker ${CMAKE_MATCH_1}${CMAKE_MATCH_2}")
    endif()
    get_filename_component(stem "${file}" NAME_WE)
    if(file MATCHES "\\.(cpp|hpp|py|sh|cmake)$" AND NOT stem MATCHES "^[a-z][a-z0-9_]*$")
        violation(names ${file} "file names are snake_case")
    endif()
    if(stem MATCHES "^(.*_)?(utils?|misc|common|manager|helpers?)$")
        violation(names ${file} "says nothing about what is in it")
    endif()
endfunction()

# [documents] docs/architecture.md says of every room what it is for, and of no folder that is none.
file(STRINGS "${ROOT}/docs/architecture.md" rows REGEX "^\\| `(shared|rtcore|hmi)/")
set(described "")
foreach(row IN LISTS rows)
    string(REGEX MATCH "^\\| `([a-z0-9_/]+)/` \\|" match "${row}")
    list(APPEND described "${CMAKE_MATCH_1}")
    if(NOT DEFINED "arrows_of_${CMAKE_MATCH_1}")
        violation(documents docs/architecture.md "names ${CMAKE_MATCH_1}, which is no room")
    endif()
endforeach()
foreach(entry IN LISTS PSICARVE_ROOMS)
    psicarve_read_room("${entry}" folder needs)
    if(NOT folder IN_LIST described)
        violation(documents docs/architecture.md "says nothing of ${folder}")
    endif()
endforeach()

file(GLOB top RELATIVE "${ROOT}" "${ROOT}/*" "${ROOT}/.*")
foreach(entry IN LISTS top)
    if(NOT entry IN_LIST allowed_top AND NOT entry IN_LIST ignored_top AND NOT entry MATCHES "^\\.?\\.$")
        violation(top-level ${entry} "not one of the root's entries")
    endif()
endforeach()

list_files(files)
list(LENGTH files file_count)
if(file_count EQUAL 0)
    message(FATAL_ERROR "no files below ROOT=${ROOT}")
endif()
foreach(file IN LISTS files)
    check_text("${file}")
    if(file MATCHES "\\.(cpp|hpp|h|c)$")
        check_includes("${file}")
    endif()
endforeach()

get_property(violations GLOBAL PROPERTY violations)
list(LENGTH violations violation_count)
if(violation_count GREATER 0)
    message(FATAL_ERROR "${violation_count} violations in ${file_count} files")
endif()
message("${file_count} files, no violation")
