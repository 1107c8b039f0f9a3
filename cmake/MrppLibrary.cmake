# mrpp_library(NAME [SOURCES ...] [HEADERS ...] [PUBLIC libs...] [PRIVATE libs...])
#
# A static library mrpp_NAME with the alias mrpp::NAME. Headers are included by their path from the project's
# root ("framework/Planner.h"), in the tree and installed alike.
# -Wno-restrict: g++ 12 warns falsely about std::string concatenation.
add_library(mrpp_options INTERFACE)
target_compile_features(mrpp_options INTERFACE cxx_std_20)
target_compile_options(mrpp_options INTERFACE
    $<BUILD_INTERFACE:-Wall;-Wextra;-Wpedantic;-Wshadow;-Wnon-virtual-dtor;-Wno-restrict;$<$<BOOL:${MRPP_WARNINGS_AS_ERRORS}>:-Werror>>)

function(mrpp_library name)
    cmake_parse_arguments(ARG "" "" "SOURCES;HEADERS;PUBLIC;PRIVATE" ${ARGN})
    add_library(mrpp_${name} STATIC ${ARG_SOURCES})
    add_library(mrpp::${name} ALIAS mrpp_${name})
    target_sources(mrpp_${name} PUBLIC FILE_SET HEADERS BASE_DIRS "${PROJECT_SOURCE_DIR}" FILES ${ARG_HEADERS})
    target_compile_features(mrpp_${name} PUBLIC cxx_std_20)
    set_target_properties(mrpp_${name} PROPERTIES
        EXPORT_NAME ${name} CXX_EXTENSIONS OFF POSITION_INDEPENDENT_CODE ON)
    target_link_libraries(mrpp_${name} PUBLIC ${ARG_PUBLIC} PRIVATE ${ARG_PRIVATE} $<BUILD_INTERFACE:mrpp_options>)
    set_property(GLOBAL APPEND PROPERTY MRPP_LIBRARIES mrpp_${name})
endfunction()
