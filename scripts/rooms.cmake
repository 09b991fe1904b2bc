# SPDX-License-Identifier: GPL-3.0-or-later
# The rooms of the code, and the arrows between them. A room is a folder and a library of that name (shared/base is
# shared_base); "a -> b c" lets files of a include headers of b and c, and of nothing else outside a. Lower rooms stand first,
# so no arrow runs in a circle. tests/architecture_test.cmake holds the include lines against this table, CMake links by it,
# and docs/architecture.md says what each room is for.
set(PSICARVE_ROOMS
    "shared/message ->"
    "shared/base -> shared/message"
    "shared/computer ->"
    "shared/machine -> shared/message"
    "shared/wording -> shared/message shared/base shared/machine"
    "shared/file -> shared/base"
    "shared/trace -> shared/base shared/machine"
    "shared/profile -> shared/message shared/wording shared/base shared/machine shared/file"
    "shared/job -> shared/message shared/wording shared/base shared/machine shared/profile"
    "shared/program -> shared/computer shared/machine"
    "shared/segment -> shared/message shared/wording shared/base shared/computer shared/machine shared/file shared/job shared/program"
    "shared/record -> shared/base shared/machine shared/file shared/profile shared/job shared/program shared/segment"
    "rtcore/process -> shared/base shared/computer shared/file"
    "rtcore/realtime -> shared/base shared/computer shared/machine shared/file rtcore/process"
    "rtcore/sim -> shared/base shared/machine shared/profile"
    "rtcore/trace -> shared/base shared/computer shared/machine shared/trace rtcore/process"
    "rtcore/port -> shared/base shared/computer shared/machine shared/profile rtcore/realtime rtcore/sim"
    "rtcore/cycle -> shared/base shared/machine rtcore/trace rtcore/port"
    "rtcore/guard -> shared/base shared/computer shared/segment rtcore/process rtcore/port"
    "rtcore/options -> shared/base shared/computer shared/file shared/profile shared/job shared/segment shared/record rtcore/port"
    "rtcore/plan -> shared/base shared/machine shared/profile shared/job shared/program rtcore/process rtcore/cycle"
    "rtcore/program -> shared/message shared/wording shared/base shared/machine shared/profile shared/program shared/segment rtcore/cycle rtcore/plan"
    "rtcore/replay -> shared/base shared/machine shared/segment shared/record rtcore/port rtcore/cycle"
    "rtcore/job -> shared/message shared/wording shared/base shared/file shared/profile shared/job shared/segment rtcore/process rtcore/plan"
    "rtcore/checkpoint -> shared/message shared/wording shared/machine shared/file shared/segment shared/record rtcore/process rtcore/cycle rtcore/job"
    "rtcore/journal -> shared/message shared/wording shared/base shared/computer shared/machine shared/file shared/segment shared/record rtcore/process rtcore/cycle rtcore/job"
    "rtcore/supervisor -> shared/message shared/wording shared/base shared/computer shared/machine shared/file shared/profile shared/job shared/segment shared/record rtcore/process rtcore/realtime rtcore/sim rtcore/trace rtcore/port rtcore/cycle rtcore/guard rtcore/options rtcore/plan rtcore/replay rtcore/job rtcore/checkpoint rtcore/journal rtcore/program"
    "hmi/model -> shared/base"
    "hmi/phrase -> shared/message shared/wording shared/base shared/machine"
    "hmi/verify/motor -> shared/base"
    "hmi/slice -> shared/base hmi/model"
    "hmi/gcode -> shared/base shared/machine shared/profile shared/program hmi/phrase"
    "hmi/offsets -> shared/base shared/computer shared/machine shared/file shared/profile shared/program shared/segment hmi/gcode"
    "hmi/manual -> shared/machine shared/profile"
    "hmi/profile -> shared/base shared/machine shared/file shared/profile hmi/phrase"
    "hmi/tool -> shared/base shared/profile hmi/model hmi/slice"
    "hmi/flat -> shared/base shared/profile hmi/model hmi/tool"
    "hmi/surface -> shared/base shared/machine shared/profile shared/job"
    "hmi/trace -> shared/base shared/machine shared/trace shared/profile shared/job"
    "hmi/doctor -> shared/computer shared/segment"
    "hmi/verify/path -> shared/base shared/machine shared/job hmi/surface"
    "hmi/verify -> shared/base shared/machine shared/profile shared/job hmi/verify/motor hmi/verify/path hmi/surface hmi/trace"
    "hmi/verify/program -> shared/base shared/machine shared/profile hmi/surface hmi/gcode hmi/trace hmi/verify"
    "hmi/machine -> shared/message shared/wording shared/base shared/computer shared/machine shared/file shared/trace shared/profile shared/job shared/segment shared/record hmi/trace hmi/verify"
    "hmi/history -> shared/base shared/file shared/record hmi/machine"
    "hmi/picture -> shared/base shared/job shared/record hmi/surface hmi/verify"
    "hmi/piece -> shared/base shared/file shared/profile shared/job hmi/model hmi/slice hmi/tool hmi/surface hmi/picture"
    "hmi/rough -> shared/base shared/profile shared/job hmi/tool hmi/piece"
    "hmi/cam -> shared/base shared/profile shared/job shared/record hmi/model hmi/slice hmi/tool hmi/flat hmi/rough"
    "hmi/report -> shared/message shared/wording shared/base shared/computer shared/machine shared/profile shared/job shared/record hmi/model hmi/slice hmi/verify hmi/machine hmi/piece hmi/cam"
    "hmi/scene -> shared/base shared/machine shared/job hmi/model hmi/slice hmi/tool hmi/surface hmi/picture hmi/piece hmi/cam"
    "hmi/cli -> shared/message shared/wording shared/base shared/computer shared/machine shared/file shared/profile shared/job shared/program shared/segment shared/record hmi/model hmi/slice hmi/gcode hmi/offsets hmi/manual hmi/profile hmi/tool hmi/flat hmi/trace hmi/doctor hmi/verify hmi/verify/program hmi/machine hmi/history hmi/picture hmi/piece hmi/rough hmi/cam hmi/report"
    "hmi/session -> shared/message shared/wording shared/base shared/computer shared/machine shared/file shared/profile shared/job shared/segment shared/record hmi/model hmi/phrase hmi/slice hmi/profile hmi/tool hmi/flat hmi/trace hmi/doctor hmi/verify hmi/machine hmi/history hmi/picture hmi/piece hmi/rough hmi/cam hmi/report hmi/scene"
    "hmi/replay -> shared/base shared/machine shared/trace shared/profile shared/job shared/record hmi/phrase hmi/profile hmi/surface hmi/trace hmi/verify hmi/machine hmi/piece hmi/cam hmi/scene hmi/session"
    "hmi/program -> shared/base shared/machine shared/file shared/profile shared/segment hmi/phrase hmi/gcode hmi/offsets hmi/machine hmi/session"
    "hmi/ui -> shared/base shared/machine shared/file shared/profile shared/segment shared/record hmi/model hmi/phrase hmi/gcode hmi/program hmi/manual hmi/profile hmi/flat hmi/doctor hmi/verify hmi/machine hmi/cam hmi/report hmi/scene hmi/session hmi/replay")

# psicarve_read_room(ENTRY FOLDER NEEDS): one line of the table.
function(psicarve_read_room entry folder needs)
    string(REGEX MATCH "^([a-z0-9_/]+) ->(.*)$" match "${entry}")
    if(NOT match)
        message(FATAL_ERROR "scripts/rooms.cmake: \"${entry}\" is not \"room -> rooms\"")
    endif()
    set(words "${CMAKE_MATCH_2}")
    set(${folder} "${CMAKE_MATCH_1}" PARENT_SCOPE)
    string(REGEX MATCHALL "[a-z0-9_/]+" words "${words}")
    set(${needs} "${words}" PARENT_SCOPE)
endfunction()

# psicarve_rooms_below(SIDE FOLDERS TARGETS): of shared, rtcore or hmi, in the order of the table.
function(psicarve_rooms_below side folders targets)
    set(found "")
    set(names "")
    foreach(entry IN LISTS PSICARVE_ROOMS)
        psicarve_read_room("${entry}" folder needs)
        if(folder MATCHES "^${side}/")
            list(APPEND found "${folder}")
            string(REPLACE "/" "_" name "${folder}")
            list(APPEND names "${name}")
        endif()
    endforeach()
    set(${folders} "${found}" PARENT_SCOPE)
    set(${targets} "${names}" PARENT_SCOPE)
endfunction()

# psicarve_room([SOURCES FILES...] [LIBS ...] [PUBLIC_LIBS ...]): the library of the folder at hand. Every .cpp file of the folder
# is named, so that none is left out unseen.
function(psicarve_room)
    cmake_parse_arguments(ARG "" "" "SOURCES;LIBS;PUBLIC_LIBS" ${ARGN})
    cmake_path(RELATIVE_PATH CMAKE_CURRENT_SOURCE_DIR BASE_DIRECTORY "${PROJECT_SOURCE_DIR}" OUTPUT_VARIABLE own)
    set(is_known FALSE)
    foreach(entry IN LISTS PSICARVE_ROOMS)
        psicarve_read_room("${entry}" folder needs)
        if(folder STREQUAL own)
            set(is_known TRUE)
            break()
        endif()
    endforeach()
    if(NOT is_known)
        message(FATAL_ERROR "${own} is not in scripts/rooms.cmake")
    endif()
    file(GLOB present RELATIVE "${CMAKE_CURRENT_SOURCE_DIR}" CONFIGURE_DEPENDS "*.cpp")
    list(REMOVE_ITEM present ${ARG_SOURCES})
    if(present)
        message(FATAL_ERROR "${own}/CMakeLists.txt does not name ${present}")
    endif()
    string(REPLACE "/" "_" name "${own}")
    string(REPLACE "/" "_" needed "${needs}")
    if(ARG_SOURCES)
        add_library(${name} STATIC ${ARG_SOURCES})
        target_link_libraries(${name} PUBLIC ${needed} ${ARG_PUBLIC_LIBS} PRIVATE ${ARG_LIBS} psicarve_options)
        target_include_directories(${name} PUBLIC "${PROJECT_SOURCE_DIR}")
    else()
        add_library(${name} INTERFACE)
        target_link_libraries(${name} INTERFACE ${needed} ${ARG_PUBLIC_LIBS})
        target_include_directories(${name} INTERFACE "${PROJECT_SOURCE_DIR}")
    endif()
endfunction()

# psicarve_side(SIDE LIBRARY [EXCEPT TARGETS...]): adds every room below SIDE, and LIBRARY, which stands for all of them but those.
function(psicarve_side side library)
    cmake_parse_arguments(ARG "" "" "EXCEPT" ${ARGN})
    psicarve_rooms_below(${side} folders targets)
    foreach(folder target IN ZIP_LISTS folders targets)
        if(folder STREQUAL "hmi/ui" AND NOT PSICARVE_WINDOW)
            list(REMOVE_ITEM targets ${target})
            continue()
        endif()
        add_subdirectory("${PROJECT_SOURCE_DIR}/${folder}" "${PROJECT_BINARY_DIR}/${folder}")
        if(NOT TARGET ${target})
            message(FATAL_ERROR "${folder}/CMakeLists.txt makes no ${target}: psicarve_room(...) does")
        endif()
    endforeach()
    list(REMOVE_ITEM targets ${ARG_EXCEPT})
    add_library(${library} INTERFACE)
    target_link_libraries(${library} INTERFACE ${targets})
endfunction()
