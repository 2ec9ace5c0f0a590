# find_package(glasspipe): the library glasspipe::glasspipe, and shaders for every lane width.
#
#     find_package(glasspipe REQUIRED)
#     add_executable(draw main.c)
#     glasspipe_shaders(draw triangle.c)

get_filename_component(GLASSPIPE_PREFIX "${CMAKE_CURRENT_LIST_DIR}/../../.." ABSOLUTE)

# Flags and instruction sets are those of shaders.mk.
function(_glasspipe_read name out)
    file(STRINGS "${GLASSPIPE_PREFIX}/share/glasspipe/shaders.mk" line REGEX "^${name} := ")
    string(REPLACE "${name} := " "" value "${line}")
    string(REPLACE " " ";" value "${value}")
    set(${out} "${value}" PARENT_SCOPE)
endfunction()

_glasspipe_read(GP_MODEL GLASSPIPE_MODEL)
_glasspipe_read(GP_GCC_OPT GLASSPIPE_GCC_OPT)
_glasspipe_read("GP_ISAS_${CMAKE_SYSTEM_PROCESSOR}" GLASSPIPE_ISAS)
if(NOT GLASSPIPE_ISAS)
    _glasspipe_read(GP_ISAS_generic GLASSPIPE_ISAS)
endif()

# What shaders cost is counted by a C++ compiler, where there is one.
include(CheckLanguage)
check_language(CXX)
if(CMAKE_CXX_COMPILER)
    enable_language(CXX)
endif()

if(NOT TARGET glasspipe::glasspipe)
    add_library(glasspipe::glasspipe SHARED IMPORTED)
    set_target_properties(glasspipe::glasspipe PROPERTIES
        IMPORTED_LOCATION "${GLASSPIPE_PREFIX}/lib/libglasspipe.so"
        INTERFACE_INCLUDE_DIRECTORIES "${GLASSPIPE_PREFIX}/include")
endif()

# One compilation of the given files, as part of the target.
function(_glasspipe_variant target variant definitions options)
    set(name "${target}_shaders_${variant}")
    add_library(${name} OBJECT ${ARGN})
    set_target_properties(${name} PROPERTIES POSITION_INDEPENDENT_CODE ON CXX_STANDARD 20
        CXX_STANDARD_REQUIRED ON)
    target_link_libraries(${name} PRIVATE glasspipe::glasspipe)
    target_compile_definitions(${name} PRIVATE ${definitions})
    target_compile_options(${name} PRIVATE ${GLASSPIPE_MODEL} ${options})
    target_sources(${target} PRIVATE $<TARGET_OBJECTS:${name}>)
endfunction()

# glasspipe_shaders(target file.c...): adds shader files to a program or library, for every lane width
# of the processor's architecture and for counting, and links it with glasspipe. Once a target.
function(glasspipe_shaders target)
    target_link_libraries(${target} PRIVATE glasspipe::glasspipe)
    set(sources "")
    set(counted "")
    foreach(file IN LISTS ARGN)
        get_filename_component(path "${file}" ABSOLUTE)
        list(APPEND sources "${path}")
        string(MAKE_C_IDENTIFIER "${file}" name)
        set(count "${CMAKE_CURRENT_BINARY_DIR}/${target}_${name}_count.cpp")
        file(GENERATE OUTPUT "${count}" CONTENT "#include \"${path}\"\n")
        list(APPEND counted "${count}")
    endforeach()

    # Where all variants are there, none may be left out when an archive is linked.
    set(all "")
    list(LENGTH GLASSPIPE_ISAS widths)
    if(CMAKE_CXX_COMPILER)
        if(widths EQUAL 3)
            set(all "GP_WEAK=")
        endif()
        _glasspipe_variant(${target} count "" "-O1;-fno-exceptions;$<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>"
            ${counted})
    endif()
    foreach(isa IN LISTS GLASSPIPE_ISAS)
        string(REPLACE ":" ";" parts "${isa};")
        list(GET parts 0 lanes)
        list(GET parts 1 name)
        list(GET parts 2 flags)
        string(REPLACE "," ";" flags "${flags}")
        _glasspipe_variant(${target} lanes${lanes} "GP_LANES=${lanes};GP_ISA_NAME=\"${name}\";${all}"
            "-O2;$<$<C_COMPILER_ID:GNU>:${GLASSPIPE_GCC_OPT}>;${flags}" ${sources})
    endforeach()
endfunction()
