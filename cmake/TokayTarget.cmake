# Compile options common to all of our own code; not of who uses the installed package.
add_library(tokayOptions INTERFACE)
target_include_directories(tokayOptions INTERFACE ${CMAKE_SOURCE_DIR}/src ${CMAKE_BINARY_DIR}/src)
target_compile_options(tokayOptions INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor)
if(TOKAY_WARNINGS_AS_ERRORS)
    target_compile_options(tokayOptions INTERFACE -Werror)
endif()
if(TOKAY_SANITIZE)
    target_compile_options(tokayOptions INTERFACE -fsanitize=address,undefined -fno-sanitize-recover=undefined -fno-omit-frame-pointer)
    target_link_options(tokayOptions INTERFACE -fsanitize=address,undefined)
    if(TOKAY_FUZZ)
        # What AddressSanitizer finds too, and takes a third of the compile time
        target_compile_options(tokayOptions INTERFACE -fno-sanitize=null,alignment,vptr,object-size,pointer-overflow)
    endif()
endif()

# Most of a compilation is reading the headers of others and instantiating their templates:
# files are compiled two dozen at a time. So names in unnamed namespaces are unique within
# a folder.
function(tokay_batch name)
    if(TOKAY_UNITY_BUILD)
        set_target_properties(${name} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 24)
    endif()
endfunction()

# For what runs once in a run (readers, tables of entries, messages, options of a
# program): compiled in less time. It must not instantiate what loops share, as Eigen's
# products: the linker keeps one copy of an inline function, whichever file it is from.
set(TOKAY_RUN_ONCE $<$<CONFIG:Release>:-O1>)

# tokay_library(<name> [STATIC] SOURCES <file>... [RUN_ONCE <file>...] LINK <library>...)
# Shared with BUILD_SHARED_LIBS, unless it is to be static.
function(tokay_library name)
    cmake_parse_arguments(arg "STATIC" "" "SOURCES;RUN_ONCE;LINK" ${ARGN})
    if(arg_STATIC)
        add_library(${name} STATIC ${arg_SOURCES})
    else()
        add_library(${name} ${arg_SOURCES})
    endif()
    target_compile_features(${name} PUBLIC cxx_std_17)
    target_link_libraries(${name} PUBLIC $<BUILD_INTERFACE:tokayOptions> ${arg_LINK})
    tokay_batch(${name})
    if(arg_RUN_ONCE)
        add_library(${name}Once OBJECT ${arg_RUN_ONCE})
        target_link_libraries(${name}Once PRIVATE tokayOptions ${arg_LINK})
        target_compile_options(${name}Once PRIVATE ${TOKAY_RUN_ONCE})
        target_sources(${name} PRIVATE $<TARGET_OBJECTS:${name}Once>)
        tokay_batch(${name}Once)
    endif()
endfunction()

# tokay_tests(<label> SOURCES <file>... LINK <library>... [PRECOMPILE <header>...])
# One GoogleTest program a library; each of its tests carries the label.
function(tokay_tests label)
    cmake_parse_arguments(arg "" "" "SOURCES;LINK;PRECOMPILE" ${ARGN})
    add_executable(${label}Tests ${arg_SOURCES})
    target_link_libraries(${label}Tests PRIVATE ${arg_LINK} GTest::gtest_main)
    target_include_directories(${label}Tests PRIVATE ${CMAKE_SOURCE_DIR}/tests)
    target_precompile_headers(${label}Tests PRIVATE <gtest/gtest.h> ${arg_PRECOMPILE})
    gtest_discover_tests(${label}Tests TEST_PREFIX ${label}. PROPERTIES LABELS ${label} TIMEOUT 300)
endfunction()
