# `cmake --build --preset release --target docs` writes the API reference to BUILD/docs/html.
find_package(Doxygen QUIET)
if(DOXYGEN_FOUND)
    set(DOXYGEN_PROJECT_NAME "MRPPSim")
    set(DOXYGEN_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}/docs")
    set(DOXYGEN_USE_MDFILE_AS_MAINPAGE "${PROJECT_SOURCE_DIR}/README.md")
    set(DOXYGEN_EXTRACT_ALL YES)
    set(DOXYGEN_GENERATE_LATEX NO)
    set(DOXYGEN_QUIET YES)
    set(DOXYGEN_STRIP_FROM_PATH "${PROJECT_SOURCE_DIR}")
    set(DOXYGEN_STRIP_FROM_INC_PATH "${PROJECT_SOURCE_DIR}")
    set(DOXYGEN_FILE_PATTERNS "*.h" "*.md")
    doxygen_add_docs(docs README.md docs framework algorithms problems reports yaml
        WORKING_DIRECTORY "${PROJECT_SOURCE_DIR}" COMMENT "Writing the API reference")
else()
    add_custom_target(docs COMMAND ${CMAKE_COMMAND} -E echo "The API reference needs doxygen: apt-get install doxygen"
        COMMAND ${CMAKE_COMMAND} -E false)
endif()
