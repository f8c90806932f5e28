# What every target shares: the language, the warnings and the floating-point rules.

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)

find_program(FLIPSIDE_CCACHE ccache)
if(FLIPSIDE_CCACHE)
    # Paths below this folder count from it, so that every checkout finds what another one compiled.
    set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env CCACHE_BASEDIR=${PROJECT_SOURCE_DIR} CCACHE_NOHASHDIR=1
                                    ${FLIPSIDE_CCACHE})
endif()

add_library(flipside_options INTERFACE)
# Contraction off: a fused multiply-add rounds once where the source rounds twice, and would make the
# bits of a run depend on compiler and machine.
target_compile_options(flipside_options INTERFACE
    -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wnon-virtual-dtor -ffp-contract=off
    -fmacro-prefix-map=${PROJECT_SOURCE_DIR}/=)  # __FILE__ is the same in every checkout
# gcc 12 sees overlapping copies in "text" + std::string (https://gcc.gnu.org/PR105651). gcc 13 and 14 take any reference
# that a function returns for one into its temporary arguments, views such as std::span and world's Node included; the
# address sanitizer finds those that do dangle.
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    target_compile_options(flipside_options INTERFACE -Wno-restrict -Wno-dangling-reference)
endif()
# In files compiled as one, names of one shadow those of another, and what is local to a file looks as if it were in a
# header; the builds file by file have the true warnings.
if(CMAKE_UNITY_BUILD)
    target_compile_options(flipside_options INTERFACE -Wno-shadow)
    if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
        target_compile_options(flipside_options INTERFACE -Wshadow=local -Wno-subobject-linkage)
    endif()
endif()
if(FLIPSIDE_SANITIZE)
    target_compile_options(flipside_options INTERFACE
        -fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer)
    # What stays within a vector's capacity is no error to the address sanitizer, but is to the library's own checks.
    target_compile_definitions(flipside_options INTERFACE _GLIBCXX_ASSERTIONS FLIPSIDE_SANITIZED)
    # By gcc's own manual the instrumentation makes this warning see ghosts (in std::regex, for one).
    if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
        target_compile_options(flipside_options INTERFACE -Wno-maybe-uninitialized)
    endif()
    target_link_options(flipside_options INTERFACE -fsanitize=address,undefined)
endif()
if(FLIPSIDE_FUZZ)
    # Counters for libFuzzer, which is linked into the fuzz targets alone. Without a record of every comparison, which
    # costs a quarter of the time and finds words and numbers that the mutator knows.
    target_compile_options(flipside_options INTERFACE -fsanitize=fuzzer-no-link -fno-sanitize-coverage=trace-cmp)
    target_link_options(flipside_options INTERFACE -fsanitize=fuzzer-no-link)
endif()

# flipside_units(TARGET SOURCE...): with CMAKE_UNITY_BUILD (see the presets) the sources of a folder are compiled as one
# unit, which reads their common headers once. Names in its anonymous namespaces must then be unique in a folder.
function(flipside_units target)
    set_target_properties(${target} PROPERTIES UNITY_BUILD_MODE GROUP
                          UNITY_BUILD_CODE_BEFORE_INCLUDE "// NOLINTNEXTLINE(bugprone-suspicious-include)")
    foreach(source ${ARGN})
        cmake_path(ABSOLUTE_PATH source OUTPUT_VARIABLE folder)
        cmake_path(GET folder PARENT_PATH folder)
        cmake_path(GET folder FILENAME folder)
        set_source_files_properties(${source} PROPERTIES UNITY_GROUP ${folder})
    endforeach()
endfunction()

# flipside_library(NAME [LINKS ...]): the sources (all of the current folder and below) as target flipside_NAME.
# Headers are included as "NAME/file.hpp".
function(flipside_library name)
    cmake_parse_arguments(ARG "" "" "SOURCES;LINKS;PRIVATE_LINKS" ${ARGN})
    set(sources ${ARG_SOURCES})
    if(NOT sources)
        file(GLOB_RECURSE sources CONFIGURE_DEPENDS *.cpp *.hpp)
    endif()
    add_library(flipside_${name} STATIC ${sources})
    flipside_units(flipside_${name} ${sources})
    target_include_directories(flipside_${name} PUBLIC ${PROJECT_SOURCE_DIR}/src)
    target_link_libraries(flipside_${name} PUBLIC ${ARG_LINKS} PRIVATE flipside_options ${ARG_PRIVATE_LINKS})
endfunction()

# flipside_places(TARGET [NAME PATH]...): what tests/places.hpp declares, for this test program.
function(flipside_places target)
    set(text "#include \"places.hpp\"\n\n")
    set(places source_dir ${PROJECT_SOURCE_DIR} ${ARGN})
    while(places)
        list(POP_FRONT places name path)
        string(APPEND text "const char* const flipside::test::${name} = \"${path}\";\n")
    endwhile()
    file(GENERATE OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/places.cpp CONTENT "${text}")
    target_sources(${target} PRIVATE ${CMAKE_CURRENT_BINARY_DIR}/places.cpp)
    target_include_directories(${target} PRIVATE ${PROJECT_SOURCE_DIR}/tests)
endfunction()

# flipside_tests(NAME [LINKS ...] [PLACES NAME PATH...]): the sources of the current folder and below as test program
# test_NAME, which knows those places.
function(flipside_tests name)
    cmake_parse_arguments(ARG "" "" "LINKS;PLACES" ${ARGN})
    file(GLOB_RECURSE sources CONFIGURE_DEPENDS *.cpp *.hpp)
    add_executable(test_${name} ${sources})
    flipside_units(test_${name} ${sources})
    flipside_places(test_${name} ${ARG_PLACES})
    target_link_libraries(test_${name} PRIVATE ${ARG_LINKS} GTest::gtest_main flipside_options)
    gtest_discover_tests(test_${name} DISCOVERY_MODE PRE_TEST DISCOVERY_TIMEOUT 60
                         PROPERTIES TIMEOUT 600 LABELS ${name})
endfunction()
